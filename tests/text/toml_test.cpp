#include "percal/text/toml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

template <class Read>
std::string refusal(const std::string& text, Read&& read) {
  try {
    const TomlTable root = parse_toml(text, "folder/scene.toml");
    read(root);
    root.finish();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

double radius_of(const TomlTable& root) {
  return root.table("particle").quantity("radius", dimension::length, positive("length"));
}

TEST(Toml, AQuantityIsReadInSi) {
  const auto root = parse_toml("a = \"26 um\"\nb = '15 MPa'\nc = 0.7\nd = \"0.7\"\n", "x");
  EXPECT_EQ(root.quantity("a", dimension::length, positive()), 26e-6);
  EXPECT_EQ(root.quantity("b", dimension::pressure, positive()), 15e6);
  EXPECT_EQ(root.quantity("c", dimension::none, positive()), 0.7);
  EXPECT_EQ(root.quantity("d", dimension::none, positive()), 0.7);
  EXPECT_EQ(root.quantity("e", dimension::length, positive(), 3.0), 3);
  EXPECT_EQ(root.optional_quantity("e", dimension::length, positive()), std::nullopt);
  EXPECT_NO_THROW(root.finish());
}

TEST(Toml, AMessageNamesFileLinePathWhatWasFoundAndWhatIsAccepted) {
  EXPECT_THAT(refusal("\n[particle]\n\nradius = \"-1 um\"\n", radius_of),
              AllOf(StartsWith("folder/scene.toml:4: particle.radius: found \"-1 um\"; accepted: a positive length"),
                    HasSubstr("um, nm")));
  EXPECT_THAT(refusal("[particle]\nradius = 26", radius_of),
              AllOf(StartsWith("folder/scene.toml:2: particle.radius: found 26 without a unit")));
  EXPECT_THAT(refusal("[particle]\nradius = \"26\"", radius_of), HasSubstr("number without a unit"));
  EXPECT_THAT(refusal("[particle]\nradius = \"26 kPa\"", radius_of),
              HasSubstr("\"26 kPa\", a pressure; accepted: a positive length"));
  EXPECT_THAT(refusal("[particle]\nradius = \"26 mpa\"", radius_of), HasSubstr("did you mean MPa?"));
  EXPECT_THAT(refusal("[particle]\nradius = true", radius_of), HasSubstr("found true; accepted"));
  EXPECT_THAT(refusal("[particle]\nradius = []", radius_of), HasSubstr("found an empty array; accepted"));
  EXPECT_THAT(refusal("particle = 1", radius_of),
              HasSubstr("folder/scene.toml:1: particle: found 1; accepted: a table: [particle]"));
  EXPECT_THAT(refusal("", radius_of), HasSubstr("folder/scene.toml: particle: found no such key"));
}

TEST(Toml, ThePathOfADottedOrImplicitTableIsFull) {
  const auto strain = [](const TomlTable& root) { root.table("target").table("erosion").number("strain", positive()); };
  EXPECT_THAT(refusal("[target.erosion]\nstrain = 0", strain),
              StartsWith("folder/scene.toml:2: target.erosion.strain: found 0"));
  EXPECT_THAT(refusal("target.erosion.strain = 0", strain),
              StartsWith("folder/scene.toml:1: target.erosion.strain: found 0"));
  EXPECT_THAT(refusal("[target]\nerosion = {strain = 0}", strain),
              StartsWith("folder/scene.toml:2: target.erosion.strain: found 0"));
}

TEST(Toml, AMissingKeyPointsAtTheTableAndAtTheMisspeltKey) {
  EXPECT_THAT(refusal("\n[particle]\nspeed = 1\nradus = \"1 um\"", radius_of),
              StartsWith("folder/scene.toml:2: particle.radius: found no such key (line 4 has \"radus\": did you "
                         "mean radius?); accepted: a positive length"));
  const auto speed_of = [](const TomlTable& root) {
    root.table("particle").quantity("speed", dimension::speed, positive());
  };
  EXPECT_THAT(refusal("[particle]\nvelocity = \"1 m/s\"", speed_of),
              HasSubstr("particle.speed: found no such key (line 2 has \"velocity\": did you mean speed?)"));
  EXPECT_THAT(refusal("[projectile]\nspeed = \"1 m/s\"", speed_of), HasSubstr("\"projectile\": did you mean particle?"));
}

TEST(Toml, AnUnknownKeyIsRefusedWithTheNearestAndTheAcceptedOnes) {
  const auto read = [](const TomlTable& root) {
    const auto particle = root.table("particle");
    particle.number("density", positive(), 1);
    particle.number("speed", positive(), 1);
  };
  EXPECT_THAT(refusal("[particle]\nspeed = 3\ndensty = 4\n", read),
              StartsWith("folder/scene.toml:3: particle.densty: found an unknown key (did you mean density?); "
                         "accepted: density, speed"));
  const std::string two = refusal("[particle]\nxyzzy = 3\n[other]\na = 1\n", read);
  EXPECT_THAT(two, HasSubstr("scene.toml:2: particle.xyzzy: found an unknown key; accepted"));
  EXPECT_THAT(two, HasSubstr("scene.toml:3: other: found an unknown key; accepted: particle"));
  EXPECT_EQ(refusal("[particle]\nspeed = 3\n", read), "accepted");
}

TEST(Toml, TablesHandedOutAreFinishedToo) {
  const auto read = [](const TomlTable& root) {
    for (const auto& series : root.tables("series")) series.table("ball").number("a", any_number());
  };
  EXPECT_EQ(refusal("[[series]]\nball.a = 1\n[[series]]\nball.a = 2\n", read), "accepted");
  EXPECT_THAT(refusal("[[series]]\nball.a = 1\n[[series]]\nball.a = 2\nball.b = 3\n", read),
              StartsWith("folder/scene.toml:5: series[2].ball.b: found an unknown key"));
}

TEST(Toml, AskingTwiceForATableGivesTheSameOne) {
  const auto root = parse_toml("[a]\nx = 1\ny = 2\n", "x");
  EXPECT_EQ(root.table("a").integer("x", 0, 9), 1);
  EXPECT_EQ(root.table("a").integer("y", 0, 9), 2);
  EXPECT_NO_THROW(root.finish());
}

TEST(Toml, NumbersAreFiniteAndInRange) {
  const Range share{.low = 0, .high = 1.2, .low_open = true};
  for (const char* text :
       {"0", "0.0", "1.3", "nan", "-nan", "inf", "-inf", "\"0.5\"", "1979-05-27", "1e999", "[0.5]"}) {
    EXPECT_NE(refusal(std::string("x = ") + text, [&](const TomlTable& root) { root.number("x", share); }), "accepted")
        << text;
  }
  for (const char* text : {"1", "1.2", "1e-9"}) {
    EXPECT_EQ(refusal(std::string("x = ") + text, [&](const TomlTable& root) { root.number("x", share); }), "accepted")
        << text;
  }
  EXPECT_THAT(refusal("x = 2", [&](const TomlTable& root) { root.number("x", share); }),
              HasSubstr("a number above 0 and up to 1.2"));
  for (const char* text : {"nan", "inf", "-inf"}) {
    EXPECT_NE(refusal(std::string("x = ") + text, [&](const TomlTable& root) { root.number("x", any_number()); }),
              "accepted")
        << text;
    EXPECT_NE(refusal(std::string("x = ") + text, [&](const TomlTable& root) { root.number("x", positive()); }),
              "accepted")
        << text;
  }
  for (const char* text : {"\"nan m\"", "\"inf m\"", "\"1e999 m\"", "nan"}) {
    EXPECT_NE(refusal(std::string("x = ") + text,
                      [&](const TomlTable& root) { root.quantity("x", dimension::length, any_number()); }),
              "accepted")
        << text;
  }
}

TEST(Toml, AWholeNumberIsWholeAndInRange) {
  const auto read = [](const TomlTable& root) { root.integer("n", 1, 1000); };
  for (const char* text : {"0", "1001", "10.0", "\"10\"", "true", "9223372036854775807", "4294967301",
                           "-9223372036854775808", "99999999999999999999"}) {
    EXPECT_NE(refusal(std::string("n = ") + text, read), "accepted") << text;
  }
  EXPECT_THAT(refusal("n = 0", read), HasSubstr("found 0; accepted: a whole number from 1 to 1000"));
  EXPECT_EQ(parse_toml("n = 1_000", "x").integer("n", 1, 1000), 1000);
  EXPECT_EQ(parse_toml("", "x").integer("n", 1, 1000, 7), 7);
}

TEST(Toml, AWordIsOneOfTheAcceptedOnes) {
  const auto read = [](const TomlTable& root) { root.word("measure", {"engineering", "true"}); };
  EXPECT_EQ(parse_toml("measure = 'true'", "x").word("measure", {"engineering", "true"}), 1);
  EXPECT_EQ(parse_toml("", "x").word("measure", {"engineering", "true"}, 0), 0);
  EXPECT_THAT(refusal("measure = 'Enginering'", read),
              HasSubstr("found \"Enginering\" (did you mean \"engineering\"?); accepted: \"engineering\", \"true\""));
  EXPECT_THAT(refusal("measure = true", read), HasSubstr("found true; accepted: \"engineering\", \"true\""));
  EXPECT_THAT(refusal("", read), HasSubstr("found no such key; accepted: \"engineering\""));
}

TEST(Toml, FlagsAndTexts) {
  const auto root = parse_toml("on = true\nname = 'gold'\nnames = ['a', 'b']\n", "x");
  EXPECT_TRUE(root.flag("on", false));
  EXPECT_TRUE(root.flag("absent", true));
  EXPECT_EQ(root.text("name"), "gold");
  EXPECT_EQ(root.text("absent", "none"), "none");
  EXPECT_THAT(root.texts("names"), ElementsAre("a", "b"));
  EXPECT_THROW(root.flag("name", false), BadInput);
  EXPECT_THROW(root.text("on"), BadInput);
  EXPECT_THROW(root.text("gone"), BadInput);
}

TEST(Toml, AnArrayNamesItsBadElement) {
  const auto read = [](const TomlTable& root) { root.quantities("radii", dimension::length, positive("length")); };
  EXPECT_THAT(parse_toml("radii = ['1 um', '2 mm']", "x").quantities("radii", dimension::length, positive()),
              ElementsAre(1e-6, 2e-3));
  EXPECT_THAT(parse_toml("x = [1, 2.5]", "x").numbers("x", positive()), ElementsAre(1, 2.5));
  EXPECT_THAT(refusal("radii = [\n'1 um',\n'2 kg']", read),
              StartsWith("folder/scene.toml:3: radii[2]: found \"2 kg\", a mass"));
  EXPECT_THAT(refusal("radii = [\n'1 um',\n2]", read),
              StartsWith("folder/scene.toml:3: radii[2]: found 2 without a unit"));
  EXPECT_THAT(refusal("radii = []", read),
              HasSubstr("found an empty array; accepted: an array, each element a positive length"));
  EXPECT_THAT(refusal("radii = '1 um'", read), HasSubstr("found \"1 um\"; accepted: an array"));
  EXPECT_THAT(refusal("series = [1]", [](const TomlTable& root) { root.tables("series"); }),
              HasSubstr("series[1]: found 1"));
  EXPECT_THAT(refusal("[series]", [](const TomlTable& root) { root.tables("series"); }),
              HasSubstr("accepted: tables: [[series]]"));
  EXPECT_TRUE(parse_toml("", "x").tables("series").empty());
}

TEST(Toml, PairsOfQuantitiesAreReadInSi) {
  const auto read = [](const TomlTable& root) { root.quantity_pairs("corners", dimension::length, any_number()); };
  EXPECT_THAT(parse_toml("corners = [['1 um', '-2 mm'], ['3 m', '0 m']]", "x")
                  .quantity_pairs("corners", dimension::length, any_number()),
              ElementsAre(std::array{1e-6, -2e-3}, std::array{3.0, 0.0}));
  EXPECT_THAT(refusal("corners = [['1 um', '2 mm'], ['3 m']]", read), HasSubstr("corners[2]: found an array"));
  EXPECT_THAT(refusal("corners = [['1 um', '2 s']]", read), HasSubstr("corners[1][2]: found \"2 s\", a time"));
  EXPECT_THAT(refusal("corners = ['1 um', '2 m']", read), HasSubstr("corners[1]: found \"1 um\""));
  EXPECT_THAT(refusal("corners = []", read), HasSubstr("an empty array"));
  EXPECT_THAT(refusal("", read), HasSubstr("corners: found no such key"));
}

TEST(Toml, WhetherAKeyHoldsAnArrayMarksNothingAsKnown) {
  const auto root = parse_toml("a = [1]\nb = 'a.csv'", "x");
  EXPECT_TRUE(root.is_array("a"));
  EXPECT_FALSE(root.is_array("b"));
  EXPECT_FALSE(root.is_array("c"));
  EXPECT_THROW(root.finish(), BadInput);
}

TEST(Toml, KeysComeInFileOrderAndStayUnknown) {
  const auto root = parse_toml("zeta = 1\nalpha = 2\n[mu]\n", "x");
  EXPECT_THAT(root.keys(), ElementsAre("zeta", "alpha", "mu"));
  EXPECT_TRUE(root.has("zeta"));
  EXPECT_FALSE(root.has("eta"));
  EXPECT_THROW(root.finish(), BadInput);
}

TEST(Toml, APathIsRelativeToTheFile) {
  const auto root =
      parse_toml("a = 'shots.csv'\nb = '../c.csv'\nc = '/d.csv'\nd = ''\ne = \"a\\u0000b\"\n", "folder/job.toml");
  EXPECT_EQ(root.path("a"), "folder/shots.csv");
  EXPECT_EQ(root.path("b"), "c.csv");
  EXPECT_EQ(root.path("c"), "/d.csv");
  EXPECT_THROW(root.path("d"), BadInput);
  EXPECT_THROW(root.path("e"), BadInput);
  EXPECT_THROW(root.path("gone"), BadInput);
  EXPECT_EQ(root.optional_path("gone"), std::nullopt);
}

TEST(Toml, MalformedTextIsRefusedWithItsLine) {
  const auto nothing = [](const TomlTable&) {};
  EXPECT_THAT(refusal("a = 1\nb = \n", nothing), StartsWith("folder/scene.toml:2: not valid TOML"));
  EXPECT_THAT(refusal("a = 1\na = 2\n", nothing), StartsWith("folder/scene.toml:2: not valid TOML"));
  EXPECT_THAT(refusal("a = \"\xff\"", nothing), StartsWith("folder/scene.toml:1: not valid TOML"));
  for (const char* text :
       {"ä = 1", "[é]", "a = 1\nЖ", "漢", "[=", "[=]", "[[\n", "[ ", "[.a]", "[a.]", "a.=1", "={", "a={=1}", "a=[=]", "a={b", "[a", "a=\"\"\"a"}) {
    EXPECT_NE(refusal(text, nothing), "accepted") << text;
  }
  EXPECT_THROW(read_toml("/nowhere/scene.toml"), BadInput);
  EXPECT_THROW(read_toml("/"), BadInput);
}

TEST(Toml, DeepNestingIsRefusedAndDoesNotExhaustTheStack) {
  std::string dotted = "a", one_line_numbers = "x = [0.5";
  for (int i = 0; i < 200000; ++i) dotted += ".a";
  for (int i = 0; i < 1000; ++i) one_line_numbers += ", 0.25";
  EXPECT_THROW(parse_toml(dotted + " = 1", "x"), BadInput);
  EXPECT_THROW(parse_toml("[" + dotted + "]", "x"), BadInput);
  std::string digits = "1";
  for (int i = 0; i < 200000; ++i) digits += ".1";
  EXPECT_THROW(parse_toml(digits + " = 1", "x"), BadInput);
  EXPECT_THROW(parse_toml("a = " + std::string(100000, '['), "x"), BadInput);
  EXPECT_THROW(parse_toml(std::string(std::size_t{17} << 20, '\n'), "x"), BadInput);
  EXPECT_EQ(parse_toml(one_line_numbers + "]", "x").numbers("x", positive()).size(), 1001u);
}

TEST(Toml, TerminalControlNeverReachesAMessage) {
  const std::string message = refusal("\"a\\u001b[2J\" = 1\nb = \"\\u001b[2J\"\n", [](const TomlTable& root) {
    EXPECT_THAT(refusal("b = \"\\u001b[2J\"", [](const TomlTable& inner) { inner.number("b", positive()); }),
                testing::Not(HasSubstr("\x1b")));
    root.text("b");
  });
  EXPECT_THAT(message, AllOf(HasSubstr("unknown key"), testing::Not(HasSubstr("\x1b"))));
}

// Reads whatever is there through every kind of getter.
void read_everything(const TomlTable& table, int depth) {
  for (const auto& key : table.keys()) {
    const std::vector<std::function<void()>> readers{
        [&] { table.quantity(key, dimension::length, positive()); },
        [&] { table.quantities(key, dimension::pressure, any_number()); },
        [&] { EXPECT_TRUE(std::isfinite(table.number(key, any_number()))); },
        [&] { table.numbers(key, any_number()); },
        [&] { table.integer(key, -5, 5); },
        [&] { table.flag(key, false); },
        [&] { table.texts(key); },
        [&] {
          table.word(key, {"free", "fixed"});
        },
        [&] { table.path(key); },
        [&] {
          if (depth < 40) read_everything(table.table(key), depth + 1);
        },
        [&] {
          for (const auto& inner : table.tables(key))
            if (depth < 40) read_everything(inner, depth + 1);
        },
    };
    for (const auto& reader : readers) {
      try {
        reader();
      } catch (const BadInput&) {
      }
    }
  }
}

TEST(Toml, MutatedTextIsReadOrRefused) {
  const std::string valid =
      "replicates = 3\n[particle]\nradius = \"1 um\"  # gold\nnames = ['a', \"b\\u00b5\"]\n[target.erosion]\nstrain = "
      "0.7\n"
      "sizes = [\n 1.5, -2e3 ]\n[[shots]]\nat = {x = 1, y.z = nan}\n[[shots]]\nday = 1979-05-27T07:32:00Z\ntext = "
      "\"\"\"\nmany\n\"\"\"\n";
  const std::string alphabet = "[]{}=.,\"'#\n\t\\ _-+0123456789abceinfux\xc2\xb5\xff\x01";
  std::mt19937 random(20240612);
  int parsed = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = valid;
    for (unsigned change = random() % 6; change-- > 0 && !text.empty();) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0: text[at] = alphabet[random() % alphabet.size()]; break;
        case 1: text.insert(at, 1, alphabet[random() % alphabet.size()]); break;
        case 2: text.erase(at, 1 + random() % 3); break;
        default: text.insert(at, valid.substr(random() % valid.size(), random() % 20));
      }
    }
    try {
      const auto root = parse_toml(text, "x");
      ++parsed;
      read_everything(root, 0);
      root.finish();
    } catch (const BadInput&) {
    }
  }
  EXPECT_GT(parsed, 600);  // unchanged texts alone are a sixth
  EXPECT_LT(parsed, 4000);
}

}  // namespace
}  // namespace percal
