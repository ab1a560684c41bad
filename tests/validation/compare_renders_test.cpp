#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/render/picture.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/checks/compare_cells.h>
#include <fairlight/validation/checks/read_cells.h>

namespace fairlight {
namespace {

using testing::TemporaryFolder;

// cornell-simple, with the albedo of the red wall, its first surface, times `factor`.
View with_red_wall(double factor) {
  View view = cornell_simple();
  Scene scene;
  for (const Surface& surface : view.scene.surfaces()) {
    const bool red = scene.surfaces().empty();
    const Sphere<double>& s = surface.shape;
    scene.add_wall(s.anchor, s.normal, 1 / s.curvature,
                   red ? Material(factor * surface.material.albedo) : surface.material, surface.radiance);
  }
  view.scene = scene;
  return view;
}

// Renders eight pictures of 64 x 64 pixels with 64 samples each, and returns their paths.
std::vector<std::string> eight(const TemporaryFolder& folder, const std::string& name, double factor) {
  RenderSettings settings;
  settings.width = settings.height = 64;
  settings.light_sampling = LightPoints::cone;
  const View view = with_camera_of(settings, with_red_wall(factor));
  std::vector<std::string> paths;
  for (const char* number : {"1", "2", "3", "4", "5", "6", "7", "8"}) {
    Picture picture{settings, {}, Film(64, 64)};
    const std::uint64_t seed = fresh_seed();
    picture.samples.add(seed, {0, 64});
    render_image(view, settings, seed, {0, 64}, 1, picture.film, {});
    paths.push_back(folder / name + number + ".exr");
    write_exr(paths.back(), picture);
  }
  return paths;
}

Comparison compare(const std::vector<std::string>& a, const std::vector<std::string>& b, bool by_pictures,
                   double alpha) {
  const ComparedCells compared = read_cells(a, b, {.by_pictures = by_pictures});
  EXPECT_NE(compared.a.from_error_layer, by_pictures);
  return compare_cells(compared.cells, compared.a, compared.b, {.alpha = alpha});
}

// A wall 3 % too dark makes the balanced mean of red 1.4 % darker: ten standard errors.
TEST(CompareRenders, SeesAWallThatIsThreePerCentTooDark) {
  const TemporaryFolder folder;
  const std::vector<std::string> right = eight(folder, "right", 1), again = eight(folder, "again", 1),
                                 dark = eight(folder, "dark", 0.97);
  const Comparison seen = compare(dark, right, false, 1e-3);
  EXPECT_EQ(seen.balanced[0].verdict, Likeness::different);
  EXPECT_LT(seen.balanced[0].interval.hi, 0);
  EXPECT_NE(compare(again, right, false, 1e-7).verdict, Likeness::different);
  EXPECT_NE(compare(again, right, true, 1e-7).verdict, Likeness::different);
}

}  // namespace
}  // namespace fairlight
