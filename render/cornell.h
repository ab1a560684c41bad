#pragma once

#include <string>
#include <vector>

#include <fairlight/render/camera.h>
#include <fairlight/render/scene.h>

namespace fairlight {

/// A built-in scene with the camera that its picture is taken with.
struct View {
  std::string name;
  Scene scene;
  Camera camera;
};

/// The names of the built-in scenes.
std::vector<std::string> scene_names();

/// A built-in scene by name. Throws std::invalid_argument, naming those that exist, for any other.
View built_in_scene(const std::string& name);

}  // namespace fairlight
