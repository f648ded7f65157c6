// The page to play with in headless Chromium: its controls are moved, by script and by keys, and what it then says is held against
// percal predict and percal dose. Skips where there is no chromium.
#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <sstream>

#include "percal/base/version.hpp"
#include "predict/explorer_models.hpp"
#include "support/browser.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double rounding_of_roots = 1e-7;  // relative: quantiles are solved for on both sides

// "26.13 µm" in m.
double length_in(const std::string& words) {
  std::istringstream stream(words);
  double value = 0;
  std::string unit;
  stream >> value >> unit;
  return value * (unit == "m" ? 1 : unit == "mm" ? 1e-3 : unit == "µm" ? 1e-6 : unit == "nm" ? 1e-9 : NAN);
}

class SlowExplorer : public test::Program {
 protected:
  void SetUp() override {
    if (!test::chromium_is_there()) GTEST_SKIP() << "chromium is not there";
  }

  void open(const ShotModel& model) {
    write("gel.json",
          json{{"schema", result_schema}, {"command", "calibrate"}, {"shot_model", shot_model_to_json(model)}}.dump());
    const Ended ended = run({"report", "gel.json", "--explore", "--quiet"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    browser_.reset();
    browser_ = std::make_unique<test::Browser>(path("profile"));
    browser_->resize(1280, 900);
    browser_->open_page(path("explore.html"));
    wait();
  }
  void wait() { ASSERT_TRUE(browser_->wait_until("explorer.ariaBusy === 'false'")) << complaints(); }
  std::string complaints() const { return json(browser_->complaints()).dump(); }

  // As if it had been typed into the number's field, or chosen from the list.
  void choose(const std::string& id, const std::string& value) {
    browser_->value_of(
        "{ const field = document.getElementById('" + id + "-number') ?? document.getElementById('" + id +
        "'); field.value = '" + value +
        "'; field.dispatchEvent(new Event(field.tagName === 'SELECT' ? 'change' : 'input', {bubbles: true})); }");
    wait();
  }
  double number(const std::string& id) {
    return browser_->value_of("Number(document.getElementById('" + id + "').value)");
  }
  std::string text(const std::string& id) {
    return browser_->value_of("document.getElementById('" + id + "').textContent");
  }

  // What percal predict says where it is called as the page shows.
  json predicted() {
    std::string command = text("command");
    EXPECT_THAT(command, HasSubstr("percal predict "));
    for (char& quote : command)
      if (quote == '"') quote = '\x01';
    for (char& quote : command)
      if (quote == '\'') quote = '"';
    std::vector<std::string> words = test::words_of(command);
    words.erase(words.begin());
    for (std::string& word : words)
      for (char& quote : word)
        if (quote == '\x01') quote = '"';
    words.push_back("--json");
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 0) << command << "\n" << ended.err;
    return json::parse(ended.out)["shots"][0];
  }
  void expect_as_predicted(const std::string& what) {
    SCOPED_TRACE(what);
    const json said = predicted();
    const auto same = [&](const std::string& id, double wanted) {
      const double shown = number(id);
      EXPECT_NEAR(shown / wanted, 1, rounding_of_roots) << id << " " << shown << " " << wanted;
      EXPECT_NEAR(length_in(text(id)) / wanted, 1, 5.001e-4) << id << " " << text(id);  // four digits are shown
    };
    same("depth", said["depth_m"]);
    for (const std::string end : {"low", "high"}) {
      same("mean-" + end, said["mean_interval_m"][end]);
      same("shot-" + end, said["shot_interval_m"][end]);
    }
    const bool shows_passing = browser_->value_of("document.getElementById('passes') !== null");
    EXPECT_EQ(shows_passing, !said["speed_left"].is_null() || said["passes_probability"] >= 0.005);
    if (shows_passing) {
      EXPECT_NEAR(number("passes"), said["passes_probability"], rounding_of_roots);
    }
    if (!said["speed_left"].is_null()) {
      const double left = said["speed_left"]["speed_left_m_s"];
      EXPECT_NEAR(number("speed-left"), left, rounding_of_roots * std::max(left, 1.0));
    }
    std::size_t beyond = 0;
    const std::string notes = text("notes");
    for (std::size_t at = 0; (at = notes.find("Beyond what was fitted", at)) != std::string::npos; ++at) ++beyond;
    EXPECT_EQ(beyond, said["outside"].size()) << notes;
  }
  void TearDown() override {
    if (!browser_) return;
    EXPECT_THAT(browser_->fetched(), IsEmpty());
    EXPECT_THAT(browser_->complaints(), IsEmpty());
    browser_.reset();
  }

  std::unique_ptr<test::Browser> browser_;
};

TEST_F(SlowExplorer, SaysOfShotsWhatPercalPredictSays) {
  open(test::model_of_two_gels());
  expect_as_predicted("as it opens");
  choose("speed", "93.7");
  expect_as_predicted("another speed");
  choose("diameter", "2.2");
  choose("density", "4540");
  choose("layer-depth", "50");
  expect_as_predicted("another sphere, into a target that it may pass");
  choose("material", "1");
  expect_as_predicted("another material");
  choose("hypothesis", "1");
  choose("speed", "220");
  expect_as_predicted("a scatter that is known, beyond all runs");
  EXPECT_THAT(text("notes"), HasSubstr("contradict"));
}

TEST_F(SlowExplorer, SaysItWithLawsAndCoversAndWhatPasses) {
  open(test::model_of_everything());
  expect_as_predicted("as it opens");
  for (const char* diameter : {"2", "3.5"}) {  // on both sides of the cell
    choose("diameter", diameter);
    for (const char* speed : {"30", "140"}) {
      choose("speed", speed);
      expect_as_predicted(diameter + std::string(" mm at ") + speed + " m/s");
    }
  }
  choose("layer-depth", "20");
  expect_as_predicted("a layer that is passed");
  EXPECT_GT(number("speed-left"), 0);
}

TEST_F(SlowExplorer, APowdersDoseIsThatOfPercalDose) {
  open(test::model_of_two_gels());
  choose("powder-diameter", "3");
  choose("spread", "20");
  choose("breach", "600");  // beyond the slider's end
  choose("layer-depth", "180");
  for (const std::string weighting : {"number", "mass"}) {
    choose("weighting", weighting);
    write("dose.toml",
          "calibration = \"gel.json\"\nmaterial = \"gel\"\nbreach = \"600 kg/(m s)\"\nlayer_depth = \"180 "
          "mm\"\n[powder]\ndensity = \"7800 "
          "kg/m3\"\nspeed = \"60 m/s\"\n"
          "[powder.diameter]\nmean = \"3 mm\"\ndeviation = \"0.6 mm\"\nweighting = \"" +
              weighting + "\"\n");
    const Ended ended = run({"dose", "dose.toml", "--json", "--out", "none"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const json dose = json::parse(ended.out);
    for (const std::string by : {"mass", "number"}) {
      SCOPED_TRACE(weighting + " " + by);
      EXPECT_NEAR(number(by + "-bounced"), dose["by_" + by]["bounced"]["best"], 5e-4);
      EXPECT_NEAR(number(by + "-passed"), dose["by_" + by]["passed"]["best"], 5e-4);
      const auto& depths = dose["depths_by_" + by];
      EXPECT_NEAR(number(by + "-mean") / depths["mean_m"]["best"].get<double>(), 1, 5e-4);
      EXPECT_NEAR(number(by + "-deviation") / depths["deviation_m"]["best"].get<double>(), 1, 5e-4);
    }
  }
}

// A stiffer material stops the sphere earlier, by the model's own emulator; the band is then that of one point.
TEST_F(SlowExplorer, AChosenMaterialIsOnePoint) {
  const ShotModel model = test::model_of_two_gels();
  open(model);
  const double depth = number("depth"), spread = number("mean-high") / number("mean-low");
  choose("mu", "300");
  choose("alpha", "7");
  choose("strain", "0.9");
  ShotModel chosen = model;
  LayerMaterial point = test::true_gel;
  point.mu_true = 300e3;
  point.alpha = 7;
  point.erosion_strain = 0.9;
  chosen.hypotheses[0].materials[0].points = {point};
  const SphereShot shot = model.shots[0];
  const DepthPrediction wanted = Predictor(chosen, 0, 0, model.level).depths(std::span(&shot, 1)).front();
  EXPECT_NEAR(number("depth") / wanted.depth, 1, rounding_of_roots);
  EXPECT_NEAR(number("shot-high") / wanted.shot.high, 1, rounding_of_roots);
  EXPECT_NEAR(number("mean-low") / wanted.mean.low, 1, rounding_of_roots);
  EXPECT_LT(number("mean-high") / number("mean-low"), spread);
  EXPECT_THAT(text("notes"), HasSubstr("One point"));
  browser_->value_of("document.getElementById('back').click()");
  wait();
  EXPECT_EQ(number("depth"), depth);
}

TEST_F(SlowExplorer, AKeyMovesASliderAndTheNumberFollows) {
  open(test::model_of_two_gels());
  const double speed = number("speed-number"), depth = number("depth");
  browser_->value_of("document.getElementById('speed').focus()");
  for (int k = 0; k < 3; ++k) browser_->press("ArrowRight", 39);
  wait();
  EXPECT_GT(number("speed-number"), speed);
  EXPECT_GT(number("depth"), depth);
  EXPECT_THAT(browser_
                  ->value_of("document.getElementById('speed').ariaValueText ?? "
                             "document.getElementById('speed').getAttribute('aria-valuetext')")
                  .get<std::string>(),
              HasSubstr(" m/s"));
  expect_as_predicted("by the arrow");
  const double moved = number("depth");
  choose("speed", "-3");
  EXPECT_EQ(number("depth"), moved);
  EXPECT_EQ(browser_->value_of("document.getElementById('speed-number').validity.valid"), false);
  // Every control is reached by the tabulator.
  browser_->value_of("document.activeElement.blur(); window.scrollTo(0, 0)");
  std::set<std::string> reached;
  for (int k = 0; k < 60; ++k) {
    browser_->press("Tab", 9);
    reached.insert(browser_->value_of("document.activeElement.id").get<std::string>());
  }
  for (const char* id :
       {"hypothesis", "material", "diameter", "speed-number", "mu", "alpha", "strain", "spread", "breach", "weighting"})
    EXPECT_TRUE(reached.contains(id)) << id;
}

constexpr const char* controls_that_fail = R"((() => {
  const faults = [];
  for (const e of document.querySelectorAll('input, select, button, summary'))
    if (e.offsetParent && e.getBoundingClientRect().height < 44) faults.push('too small for a finger: ' + e.tagName + ' ' + e.id);
  for (const e of document.querySelectorAll('input, select'))
    if (e.labels.length === 0 && !e.ariaLabel) faults.push('no label: ' + e.id);
  if (document.querySelectorAll('svg path.curve').length < 2) faults.push('no curves');
  return faults.join('; ');
})())";

TEST_F(SlowExplorer, FitsAPhoneAndAScreen) {
  for (const ShotModel& model : {test::model_of_two_gels(), test::model_of_everything()}) {
    open(model);
    for (const int width : {320, 1280}) {
      browser_->resize(width, 800, width < 400);
      usleep(300000);
      wait();
      EXPECT_EQ(browser_->value_of(test::what_does_not_fit), "") << width;
      EXPECT_EQ(browser_->value_of(controls_that_fail), "") << width;
    }
  }
}

}  // namespace
}  // namespace percal
