#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/picture.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using testing::read_file;
using testing::TemporaryFolder;
using testing::write_file;

template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

const std::pair<const char*, double RenderSettings::*> numbers[] = {
    {"aperture", &RenderSettings::aperture}, {"focus", &RenderSettings::focus}, {"fov", &RenderSettings::fov}};

constexpr double infinite = std::numeric_limits<double>::infinity();

// NaN is neither given nor not given, and JSON has null for all three.
TEST(RenderSettings, AreRefusedByNameWithANumberThatIsNotFinite) {
  for (const auto& [name, member] : numbers) {
    for (double value : {std::nan(""), infinite, -infinite}) {
      RenderSettings settings;
      settings.*member = value;
      const std::string quoted = formatted("\"%s\"", std::string(name).c_str());
      EXPECT_THAT(refusal([&] { check_finite(settings); }), HasSubstr(quoted));
      EXPECT_THAT(refusal([&] { view_of(settings); }), HasSubstr(quoted));
      EXPECT_THAT(refusal([&] { with_camera_of(settings, built_in_scene("hallway")); }), HasSubstr(quoted));
      EXPECT_THAT(refusal([&] { (void)nlohmann::json(settings); }), HasSubstr(quoted));
      Film film(1, 1);
      const View view = built_in_scene("cornell-simple");
      EXPECT_THAT(refusal([&] { render_image(view, settings, 1, {0, 1}, 1, film, {}); }), HasSubstr(quoted));
    }
  }
  EXPECT_NO_THROW(check_finite({}));
}

TEST(RenderSettings, AreTheSameThroughJson) {
  RenderSettings settings;
  settings.scene = "hallway";
  settings.width = 7;
  settings.points = 16;
  settings.fov = 37.5;
  const nlohmann::json json = settings;
  EXPECT_EQ(json.size(), 17u);
  const auto back = json.get<RenderSettings>();
  EXPECT_EQ(back.scene, "hallway");
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.points, 16u);
  EXPECT_EQ(back.fov, 37.5);
  EXPECT_EQ(nlohmann::json(back), json);
}

// Files of earlier versions have these texts, and a resumed render compares them.
TEST(RenderSettings, HaveTheTextsThatFilesHave) {
  EXPECT_EQ(nlohmann::json(RenderSettings()).dump(),
            R"({"aperture":-1.0,"bounce":"cosine","direct":"light","filter":"tent","focus":-1.0,"fov":-1.0,)"
            R"("height":256,"light_sampling":"area","max_depth":-1,"points":1,"random":"independent",)"
            R"("real":"packet","roulette":"albedo","roulette_depth":-1,"scene":"cornell-simple",)"
            R"("which_light":"one","width":256})");
}

TEST(RenderSettings, KeepEveryStrategyThroughJson) {
  const nlohmann::json usual = RenderSettings();
  for_each_strategy_kind([&](const auto& table) {
    for (const auto& row : table.rows) {
      nlohmann::json json = usual;
      json[table.setting] = row.name;
      EXPECT_EQ(nlohmann::json(json.get<RenderSettings>()), json) << table.setting << " " << row.name;
    }
  });
}

TEST(RenderSettings, RefuseAStrategyThatDoesNotExistByItsNameAndTheNearest) {
  const auto refused = [](const char* setting, const char* value) {
    nlohmann::json json = RenderSettings();
    json[setting] = value;
    return refusal([&] { (void)json.get<RenderSettings>(); });
  };
  EXPECT_EQ(refused("bounce", "uniforn"),
            "the setting \"bounce\" is \"uniforn\" (did you mean uniform? see fairlight render --help)");
  EXPECT_EQ(refused("light_sampling", "solid_angle"),
            "the setting \"light_sampling\" is \"solid_angle\" (did you mean solid-angle? see fairlight render "
            "--help)");
  for_each_strategy_kind([&](const auto& table) {
    for (const char* value : {"sideways", ""})
      EXPECT_THAT(refused(table.setting, value), HasSubstr(formatted("\"%s\" is \"%s\"", table.setting, value)));
  });
}

TEST(RenderSettings, AreRefusedByNameWhereOneIsMissingOrOfAnotherKind) {
  const nlohmann::json good = RenderSettings();
  for (const auto& [name, value] : good.items()) {
    const std::string quoted = "\"" + name + "\"";
    nlohmann::json bad = good;
    bad[name] = nullptr;
    EXPECT_THAT(refusal([&] { (void)bad.get<RenderSettings>(); }), HasSubstr(quoted + " is null"));
    bad[name] = nlohmann::json::array();
    EXPECT_THAT(refusal([&] { (void)bad.get<RenderSettings>(); }), HasSubstr(quoted));
    bad.erase(name);
    EXPECT_THAT(refusal([&] { (void)bad.get<RenderSettings>(); }), HasSubstr(quoted + " is missing"));
  }
  nlohmann::json bad = good;
  for (const char* width : {"20.5", "4294967552", "\"20\"", "true"}) {
    bad["width"] = nlohmann::json::parse(width);
    EXPECT_THAT(refusal([&] { (void)bad.get<RenderSettings>(); }), HasSubstr("\"width\"")) << width;
  }
}

// As fairlight once wrote it for --aperture nan.
TEST(Picture, IsRefusedByTheNameOfASettingThatIsNull) {
  const TemporaryFolder folder;
  RenderSettings settings;
  settings.width = settings.height = 1;
  Picture picture{settings, {}, Film(1, 1)};
  picture.samples.add(1, {0, 1});
  picture.film.add(0, 0, {1, 1, 1});
  for (const auto& [name, member] : numbers) {
    write_exr(folder / "a.exr", picture);
    std::string bytes = read_file(folder / "a.exr");
    const std::string number = "\"" + std::string(name) + "\":-1.0";
    const std::size_t at = bytes.find(number);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, number.size(), "\"" + std::string(name) + "\":null");
    write_file(folder / "a.exr", bytes);
    EXPECT_THAT(refusal([&] { read_exr(folder / "a.exr"); }), HasSubstr("\"" + std::string(name) + "\" is null"));
  }
}

}  // namespace
}  // namespace fairlight
