#include <stdexcept>

#include <fairlight/render/cornell.h>

namespace fairlight {
namespace {

const Rgb<double> black(0, 0, 0);
const Rgb<double> red(.75, .25, .25);
const Rgb<double> blue(.25, .25, .75);
const Rgb<double> grey(.75, .75, .75);

// The box without its front: x from 1 to 99, y from 0 to 81.6, z from 0 towards the camera. The walls are spheres
// of radius 1e5, seen from inside, as in the paper's renderer (and in smallpt, Beason 2007, from which it took
// them).
void add_walls(Scene& scene) {
  constexpr double radius = 1e5;
  scene.add_wall({1, 40.8, 81.6}, {-1, 0, 0}, radius, red, black);
  scene.add_wall({99, 40.8, 81.6}, {1, 0, 0}, radius, blue, black);
  scene.add_wall({50, 40.8, 0}, {0, 0, -1}, radius, grey, black);
  scene.add_wall({50, 0, 81.6}, {0, -1, 0}, radius, grey, black);
  scene.add_wall({50, 81.6, 81.6}, {0, 1, 0}, radius, grey, black);
}

Camera box_camera() {
  return Camera({.eye = {50, 52, 295.6}, .look = {0, -0.042612, -1}, .image_height = 0.5135, .start = 140});
}

View cornell_simple() {
  Scene scene;
  add_walls(scene);
  const Rgb<double> white(.799, .799, .799);
  scene.add_sphere({27, 16.5, 47}, 16.5, white, black);
  scene.add_sphere({73, 16.5, 78}, 16.5, white, black);
  scene.add_sphere({50, 65.1, 81.6}, 1.5, black, Rgb<double>(400, 400, 400));
  return {"cornell-simple", scene, box_camera()};
}

}  // namespace

std::vector<std::string> scene_names() { return {"cornell-simple"}; }

View built_in_scene(const std::string& name) {
  if (name == "cornell-simple") return cornell_simple();
  std::string message = "there is no scene \"" + name + "\" (choose one of:";
  for (const std::string& known : scene_names()) message += " " + known;
  throw std::invalid_argument(message + ")");
}

}  // namespace fairlight
