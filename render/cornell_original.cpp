#include <fairlight/render/built_in_scenes.h>

namespace fairlight {

/// The measured Cornell box, in millimetres. The measured walls deviate from rectangles by up to 6
/// mm and the blocks by up to 1 mm; here they are rectangles. The measured spectra are replaced by
/// the usual colours: white (.725, .71, .68), red (.63, .065, .05), green (.14, .45, .091), light
/// (17, 12, 4).
/// Source   Cornell University Program of Computer Graphics, "Cornell Box Data"
/// (graphics.cornell.edu/online/box/data.html); Goral, Torrance, Greenberg, Battaile 1984
View cornell_original() {
  const Rgb<double> white(.725, .71, .68);
  const Rgb<double> red(.63, .065, .05);
  const Rgb<double> green(.14, .45, .091);
  const Rgb<double> black(0, 0, 0);
  constexpr double width = 556, height = 548.8, depth = 559.2;
  Scene scene;
  scene.add_rectangle({0, 0, 0}, {width, 0, 0}, {0, 0, depth}, white, black);
  scene.add_rectangle({0, height, 0}, {width, 0, 0}, {0, 0, depth}, white, black);
  scene.add_rectangle({0, 0, depth}, {width, 0, 0}, {0, height, 0}, white, black);
  scene.add_rectangle({0, 0, 0}, {0, 0, depth}, {0, height, 0}, green, black);
  scene.add_rectangle({width, 0, 0}, {0, 0, depth}, {0, height, 0}, red, black);
  // The light is 0.1 mm below the ceiling.
  scene.add_rectangle({213, height - 0.1, 227}, {130, 0, 0}, {0, 0, 105}, black, Rgb<double>(17, 12, 4));

  // Adds an upright block on the floor, by the middle and the edges of its top.
  const auto add_block = [&](const Vec3<double>& top, const Vec3<double>& x, const Vec3<double>& z) {
    const Vec3<double> up(0, top.y(), 0);
    const Vec3<double> corner = top - (x + z) / 2;
    scene.add_rectangle(corner, x, z, white, black);
    for (const Vec3<double>& foot : {Vec3<double>(corner - up), Vec3<double>(corner + z - up)})
      scene.add_rectangle(foot, x, up, white, black);
    for (const Vec3<double>& foot : {Vec3<double>(corner - up), Vec3<double>(corner + x - up)})
      scene.add_rectangle(foot, z, up, white, black);
  };
  add_block({185.5, 165, 169}, {159, 0, 48.5}, {-48.5, 0, 159});
  add_block({368.5, 330, 351.25}, {-158.75, 0, 49.25}, {49.25, 0, 158.75});
  return {"cornell-original", scene,
          Camera({.eye = {278, 273, -800}, .look = {0, 0, 1}, .image_height = 0.025 / 0.035})};
}

}  // namespace fairlight
