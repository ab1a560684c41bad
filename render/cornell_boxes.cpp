#include <fairlight/render/built_in_scenes.h>

namespace fairlight {
namespace {

const Rgb<double> black(0, 0, 0);
const Rgb<double> red(.75, .25, .25);
const Rgb<double> blue(.25, .25, .75);
const Rgb<double> grey(.75, .75, .75);
const Rgb<double> white(.799, .799, .799);

// The box, open at the front: x from 1 to 99, y from 0 to 81.6, z from 0 towards the camera.
void add_walls(Scene& scene) {
  constexpr double radius = 1e5;
  scene.add_wall({1, 40.8, 81.6}, {-1, 0, 0}, radius, red, black);
  scene.add_wall({99, 40.8, 81.6}, {1, 0, 0}, radius, blue, black);
  scene.add_wall({50, 40.8, 0}, {0, 0, -1}, radius, grey, black);
  scene.add_wall({50, 0, 81.6}, {0, -1, 0}, radius, grey, black);
  scene.add_wall({50, 81.6, 81.6}, {0, 1, 0}, radius, grey, black);
}

View in_the_box(const std::string& name, const Scene& scene) {
  return {name, scene,
          Camera({.eye = {50, 52, 295.6}, .look = {0, -0.042612, -1}, .image_height = 0.5135, .start = 140})};
}

void add_two_spheres(Scene& scene) {
  scene.add_sphere({27, 16.5, 47}, 16.5, white, black);
  scene.add_sphere({73, 16.5, 78}, 16.5, white, black);
}

}  // namespace

View cornell_simple() {
  Scene scene;
  add_walls(scene);
  add_two_spheres(scene);
  scene.add_sphere({50, 65.1, 81.6}, 1.5, black, Rgb<double>(400, 400, 400));
  return in_the_box("cornell-simple", scene);
}

View cornell_complex() {
  Scene scene;
  add_walls(scene);
  scene.add_sphere({20, 16.5, 40}, 16.5, white, black);
  scene.add_sphere({50, 16.5, 80}, 16.5, white, black);
  scene.add_sphere({75, 16.5, 120}, 16.5, white, black);
  scene.add_sphere({50, 65.1, 40}, 1.5, black, Rgb<double>(400, 400, 400));
  scene.add_sphere({50, 65.1, 120}, 1.5, black, Rgb<double>(400, 400, 400));
  return in_the_box("cornell-complex", scene);
}

View cornell_materials() {
  using Kind = Material::Kind;
  Scene scene;
  add_walls(scene);
  scene.add_sphere({24, 16.5, 45}, 16.5, {Kind::mirror, Rgb<double>(.9, .9, .9), 1}, black);
  scene.add_sphere({76, 16.5, 55}, 16.5, {Kind::metal, Rgb<double>(.95, .75, .4), 0.25}, black);
  scene.add_sphere({36, 11, 100}, 11, {Kind::gloss, Rgb<double>(.3, .6, .35), 40}, black);
  scene.add_sphere({66, 12, 105}, 12, {Kind::glass, Rgb<double>(1, 1, 1), 1.5}, black);
  scene.add_sphere({50, 65.1, 81.6}, 6, black, Rgb<double>(25, 25, 25));
  return in_the_box("cornell-materials", scene);
}

View many_lights() {
  Scene scene;
  add_walls(scene);
  add_two_spheres(scene);
  for (int i = 0; i < 1000; ++i) {
    const int x = i % 10, y = i / 10 % 10, z = i / 100;
    const double radiance = 2.0 * (i % 7 + 1) * (i % 11 + 1);
    const Rgb<double> colour(1, 0.6 + 0.04 * x, 0.6 + 0.04 * z);
    scene.add_sphere({8 + 9.3 * x, 48 + 3.2 * y, 8 + 14.0 * z}, 0.15, black, radiance * colour);
  }
  return in_the_box("many-lights", scene);
}

View hallway() {
  Scene scene;
  constexpr double radius = 1e5;
  scene.add_wall({-30, 30, 0}, {-1, 0, 0}, radius, red, black);
  scene.add_wall({30, 30, 0}, {1, 0, 0}, radius, blue, black);
  scene.add_wall({0, 0, 0}, {0, -1, 0}, radius, grey, black);
  scene.add_wall({0, 60, 0}, {0, 1, 0}, radius, grey, black);
  scene.add_wall({0, 30, -300}, {0, 0, -1}, radius, grey, black);
  for (int i = 0; i < 7; ++i) {
    scene.add_sphere({-14.0 + 4.5 * i, 8, 40.0 - 40 * i}, 8, white, black);
  }
  for (int i = 0; i < 3; ++i) scene.add_sphere({0, 54, 20.0 - 110 * i}, 4, black, Rgb<double>(30, 28, 25));
  return {"hallway", scene,
          Camera({.eye = {-4, 22, 110},
                  .look = {0.02, -0.1, -1},
                  .image_height = 0.6,
                  .aperture_radius = 2.5,
                  .focus_distance = 150})};
}

}  // namespace fairlight
