#include <gtest/gtest.h>

#include <fairlight/render/contact_sheet.h>

namespace fairlight {
namespace {

constexpr int size = 8;
constexpr std::uint64_t samples = 4, seed = 3;

// By the strategies of the sheet, as a picture of its own.
Film picture_of(const std::string& scene) {
  RenderSettings settings;
  settings.scene = scene;
  settings.direct = DirectLighting::mis;
  settings.which_light = WhichLight::contribution;
  Film film(size, size);
  render_image(view_of(settings), settings, seed, {0, samples}, 2, film, {});
  return film;
}

TEST(ContactSheet, ShowsEveryBuiltInSceneThreeInARow) {
  double last = 0;
  const Film sheet = contact_sheet(size, samples, seed, 2, [&](double part) {
    EXPECT_GE(part, last);
    last = part;
  });
  EXPECT_EQ(last, 1);
  const std::vector<std::string> names = scene_names();
  ASSERT_EQ(sheet.width(), 3 * size);
  ASSERT_EQ(sheet.height(), 2 * size);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Film film = picture_of(names[i]);
    const int left = static_cast<int>(i % 3) * size, top = static_cast<int>(i / 3) * size;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x)
        EXPECT_TRUE((sheet.mean(left + x, top + y) == film.mean(x, y)).all()) << names[i] << " " << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace fairlight
