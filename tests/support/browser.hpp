// Headless Chromium, driven over its own pipes by the protocol of its developer tools: a page as its reader has it, its security policy
// included. https://chromedevtools.github.io/devtools-protocol
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace percal::test {

inline bool chromium_is_there() { return std::system("command -v chromium > /dev/null 2>&1") == 0; }

// An expression for Browser::value_of(): what of a page is wider than the window and in no box that scrolls, and what is cut or too small to
// read in its plots; "" where all fits.
inline constexpr const char* what_does_not_fit = R"((() => {
  const faults = [], width = document.documentElement.clientWidth;
  const scrolls = e => e && (e.classList.contains('scroll') || scrolls(e.parentElement));
  if (document.documentElement.scrollWidth > width) faults.push('the page is ' + document.documentElement.scrollWidth + ' wide');
  for (const e of document.querySelectorAll('body *')) {
    const box = e.getBoundingClientRect();
    if (box.width === 0 || e.closest('svg') && e.tagName !== 'svg' || scrolls(e.parentElement)) continue;
    if (box.right > width + 1 || box.left < -1) faults.push(e.tagName + ' "' + e.textContent.slice(0, 40) + '" ' + e.id + ' ends at ' + box.right);
    const holdsMore = e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && getComputedStyle(e).display !== 'inline';
    const hasWords = [...e.childNodes].some(child => child.nodeType === Node.TEXT_NODE && child.data.trim());
    if (!scrolls(e) && hasWords && holdsMore)
      faults.push(e.tagName + ' holds ' + e.scrollWidth + ' in ' + e.clientWidth);
  }
  for (const text of document.querySelectorAll('svg text')) {
    const svg = text.closest('svg').getBoundingClientRect(), box = text.getBoundingClientRect();
    if (svg.width > 0 && (box.left < svg.left - 1 || box.right > svg.right + 1 || box.top < svg.top - 1 || box.bottom > svg.bottom + 1))
      faults.push('cut in a plot: ' + text.textContent.trim());
    if (svg.width > 0 && box.height > 0 && box.height < 9) faults.push('tiny in a plot: ' + text.textContent.trim());
  }
  return faults.join('; ');
})())";

class Browser {
 public:
  using Json = nlohmann::json;

  // `profile`: a folder for it alone.
  explicit Browser(const std::string& profile) {
    int commands[2], answers[2];
    if (pipe(commands) != 0 || pipe(answers) != 0) return;
    signal(SIGPIPE, SIG_IGN);
    child_ = fork();
    if (child_ == 0) {
      setpgid(0, 0);
      // First out of the way: one of the ends may be 3 or 4 itself.
      const int in = fcntl(commands[0], F_DUPFD, 10), out = fcntl(answers[1], F_DUPFD, 10);
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
      dup2(in, 3);
      dup2(out, 4);
      for (int other = 5; other < 64; ++other) close(other);
      const std::string folder = "--user-data-dir=" + profile;
      execlp("chromium", "chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--disable-background-networking", "--no-first-run", "--remote-debugging-pipe", folder.c_str(),
             "about:blank", nullptr);
      _exit(127);
    }
    close(commands[0]);
    close(answers[1]);
    to_ = commands[1];
    from_ = answers[0];
    fcntl(to_, F_SETFD, FD_CLOEXEC);
    fcntl(from_, F_SETFD, FD_CLOEXEC);
    for (int attempt = 0; attempt < 50 && session_.empty(); ++attempt) {
      session_ = session_of_a_page();
      if (session_.empty()) usleep(100000);
    }
    for (const char* domain : {"Page", "Network", "Runtime", "Log"}) call(domain + std::string(".enable"));
  }
  ~Browser() {
    if (child_ <= 0) return;
    call("Browser.close");
    close(to_);
    close(from_);
    int status = 0;
    for (int tenths = 0; tenths < 50; ++tenths) {
      if (waitpid(child_, &status, WNOHANG) != 0) return;
      usleep(100000);
    }
    kill(-child_, SIGKILL);
    waitpid(child_, &status, 0);
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void open_page(const std::string& file) {
    call("Page.navigate", {{"url", "file://" + file}});
    wait_until("document.readyState === 'complete' && location.href !== 'about:blank'");
  }
  // A window of that many pixels; a phone's has a finger and no mouse.
  void resize(int width, int height, bool phone = false) {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", phone}});
  }
  void prefer_dark() {
    call("Emulation.setEmulatedMedia",
         {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", "dark"}}})}});
  }

  // The value of an expression; an exception's words where there is one.
  Json value_of(const std::string& expression) {
    const Json answer =
        call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    if (answer.contains("exceptionDetails")) return answer["exceptionDetails"].dump();
    return answer.contains("result") ? answer["result"].value("value", Json()) : Json();
  }
  bool wait_until(const std::string& condition, int tenths = 150) {
    for (int k = 0; k < tenths; ++k) {
      if (value_of(condition) == true) return true;
      usleep(100000);
    }
    return false;
  }
  // A key as the keyboard gives it: "ArrowRight", "Tab", "End".
  void press(const std::string& key, int code) {
    for (const char* type : {"rawKeyDown", "keyUp"})
      call("Input.dispatchKeyEvent", {{"type", type}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}});
  }

  // Addresses that were asked for, the pages themselves left out; what went wrong in a page, in its own words.
  const std::vector<std::string>& fetched() const { return fetched_; }
  const std::vector<std::string>& complaints() const { return complaints_; }

  Json call(const std::string& method, const Json& parameters = Json::object()) {
    Json message{{"id", ++last_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    const std::string text = message.dump() + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
      const auto now = write(to_, text.data() + sent, text.size() - sent);
      if (now <= 0) return Json::object();
      sent += static_cast<std::size_t>(now);
    }
    while (true) {
      const std::string answer = next();
      if (answer.empty()) return Json::object();
      const Json json = Json::parse(answer);
      if (json.value("id", 0) == last_) return json.value("result", Json::object());
      take_note(json);
    }
  }

 private:
  std::string session_of_a_page() {
    const Json targets = call("Target.getTargets");
    for (const Json& target : targets.value("targetInfos", Json::array()))
      if (target["type"] == "page")
        return call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})
            .value("sessionId", "");
    return "";
  }
  std::string next() {
    std::size_t end = 0;
    while ((end = unread_.find('\0')) == std::string::npos) {
      char some[65536];
      const auto now = read(from_, some, sizeof some);
      if (now <= 0) return "";
      unread_.append(some, static_cast<std::size_t>(now));
    }
    const std::string one = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return one;
  }
  void take_note(const Json& event) {
    const std::string method = event.value("method", "");
    if (method == "Network.requestWillBeSent" && event["params"]["type"] != "Document")
      fetched_.push_back(event["params"]["request"]["url"]);
    if (method == "Runtime.exceptionThrown") complaints_.push_back(event["params"]["exceptionDetails"].dump());
    if (method == "Log.entryAdded") complaints_.push_back(event["params"]["entry"].dump());
  }

  pid_t child_ = -1;
  int to_ = -1, from_ = -1, last_ = 0;
  std::string session_, unread_;
  std::vector<std::string> fetched_, complaints_;
};

}  // namespace percal::test
