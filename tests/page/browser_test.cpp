// Pages of real results in headless Chromium: nothing is wider than the page, at 320 and 1280 pixels, and nothing is fetched.
// Skips where there is no chromium or no gnuplot.
#include <gmock/gmock.h>

#include <regex>

#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::HasSubstr;
using testing::Not;

// Put into a copy of a page. Says what is wider than the page and is in no box that scrolls, and what was fetched.
constexpr const char* look = R"(<script>
addEventListener('load', () => {
  const faults = [], width = document.documentElement.clientWidth;
  const scrolls = e => e && (e.classList.contains('scroll') || scrolls(e.parentElement));
  if (document.documentElement.scrollWidth > width) faults.push('the page is ' + document.documentElement.scrollWidth + ' wide');
  for (const e of document.querySelectorAll('body *')) {
    const box = e.getBoundingClientRect();
    if (box.width === 0 || e.closest('svg') && e.tagName !== 'svg' || scrolls(e.parentElement)) continue;
    if (box.right > width + 1 || box.left < -1) faults.push(e.tagName + ' "' + e.textContent.slice(0, 40) + '" ends at ' + box.right);
    if (!scrolls(e) && e.tagName !== 'svg' && e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && getComputedStyle(e).display !== 'inline')
      faults.push(e.tagName + ' holds ' + e.scrollWidth + ' in ' + e.clientWidth);
  }
  for (const text of document.querySelectorAll('svg text')) {
    const svg = text.closest('svg').getBoundingClientRect(), box = text.getBoundingClientRect();
    if (svg.width > 0 && (box.left < svg.left - 1 || box.right > svg.right + 1 || box.top < svg.top - 1 || box.bottom > svg.bottom + 1))
      faults.push('cut in a plot: ' + text.textContent.trim());
    if (svg.width > 0 && box.height > 0 && box.height < 9) faults.push('tiny in a plot: ' + text.textContent.trim());
  }
  for (const entry of performance.getEntriesByType('resource')) faults.push('fetched ' + entry.name);
  parent.postMessage({width, faults}, '*');
});
</script></body>)";

constexpr const char* frame =
    R"(<!DOCTYPE html><title>frame</title><body><iframe src="copy.html" style="border:0;height:800px;width:WIDTHpx"></iframe>
<script>addEventListener('message', m => { document.body.innerText = 'looked at ' + m.data.width + ': ' + m.data.faults.join('; ') + ' end'; });</script>)";

class SlowBrowser : public test::Program {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not there";
    if (std::system("command -v gnuplot > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not there";
  }

  // What Chromium makes of a page in a window that is so wide.
  std::string looked_at(const std::string& page, int width) const {
    std::string copy = std::regex_replace(page, std::regex("<meta http-equiv[^>]*>"), "");
    copy.replace(copy.rfind("</body>"), 7, look);
    write("copy.html", copy);
    write("frame.html", std::regex_replace(std::string(frame), std::regex("WIDTH"), std::to_string(width)));
    const std::string command =
        "chromium --headless=new --no-sandbox --disable-gpu --hide-scrollbars --virtual-time-budget=5000 "
        "--user-data-dir=" +
        path("profile") +
        " --host-resolver-rules=\"MAP * ~NOTFOUND\" "
        "--allow-file-access-from-files --window-size=1400,900 --dump-dom file://" +
        path("frame.html") + " > " + path("dom") + " 2> /dev/null";
    if (std::system(command.c_str()) != 0) return "chromium failed";
    return read("dom");
  }
  void expect_fits(const std::string& result) const {
    const Ended ended = run({"report", result, "-o", "page.html", "--quiet"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (const int width : {320, 1280})
      EXPECT_THAT(looked_at(read("page.html"), width), HasSubstr("looked at " + std::to_string(width) + ":  end"))
          << result;
  }
  void expect_runs(std::vector<std::string> arguments) const {
    const Ended ended = run(arguments);
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
};

TEST_F(SlowBrowser, AFitFits) {
  expect_runs({"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv", "--compare", "--weights", "tests",
               "--bootstrap", "20", "--out", "fit.out", "--quiet"});
  expect_fits("fit.out/result.json");
}

TEST_F(SlowBrowser, ARateFactorFits) {
  expect_runs({"fit", "--rate-factor", PERCAL_DATA "/synthetic/gelatin_12wt_quasistatic.csv",
               PERCAL_DATA "/synthetic/gelatin_12wt_highrate.csv", "--out", "rate.out", "--quiet"});
  expect_fits("rate.out/result.json");
}

TEST_F(SlowBrowser, AnImpactFits) {
  expect_runs({"impact", test::test_data + "layer.toml", "--replicates", "3", "--threads", "1", "--history",
               "history.csv", "--out", "impact.out", "--quiet"});
  expect_fits("impact.out/result.json");
}

TEST_F(SlowBrowser, AScaledSystemFits) {
  std::string job = text_of(test::guha2009 + "similar.toml");
  job = std::regex_replace(job, std::regex("(^|\n)output_scene[^\n]*"), "");
  for (const char* scene : {"gold.toml", "steel.toml"}) write(scene, text_of(test::guha2009 + scene));
  expect_runs({"scale", write("similar.toml", job), "--out", "scale.out", "--quiet"});
  expect_fits("scale.out/result.json");
}

TEST_F(SlowBrowser, AStudyOfErrorAgainstTimeFits) {
  expect_runs({"study", test::test_data + "layer.toml", "--error-vs-time", "--meshes", "3,4,5,6", "--replicates", "3",
               "--threads", "1", "--out", "study.out", "--quiet"});
  expect_fits("study.out/result.json");
}

TEST_F(SlowBrowser, WhatDoesNotFitIsSeen) {
  const std::string page =
      "<!DOCTYPE html><html><body><p style=\"width:700px\">wide</p><img "
      "src=\"http://nowhere.invalid/x.png\"></body></html>";
  const std::string words = looked_at(page, 320);
  EXPECT_THAT(words, HasSubstr("P \"wide\" ends at 7"));
  EXPECT_THAT(words, HasSubstr("fetched http://nowhere.invalid/x.png"));
}

}  // namespace
}  // namespace percal
