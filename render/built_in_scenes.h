#pragma once

#include <string>
#include <vector>

#include <fairlight/render/camera.h>
#include <fairlight/render/scene.h>

namespace fairlight {

/// A built-in scene and its camera.
struct View {
  std::string name;
  Scene scene;
  Camera camera;
};

/// The scene of the paper's renderer: a box of five walls, each a sphere of radius 1e5 seen from
/// inside.
/// Source   the paper, 2.2; smallpt (Beason 2007), from which the paper's renderer took it
View cornell_simple();
View cornell_complex();
/// The same box with a mirror, glass, rough metal and gloss, under a larger light of equal power.
View cornell_materials();
/// The same box lit by 1000 small spheres of unequal power; every tenth emits nothing.
View many_lights();
/// The measured Cornell box, made of rectangles. Source: see cornell_original.cpp
View cornell_original();
/// A row of spheres in a hallway, through a lens that is focused on the third. Source: the paper,
/// Figs. 6 and 7
View hallway();

/// The names of the built-in scenes.
std::vector<std::string> scene_names();

/// A built-in scene by name. Throws std::invalid_argument, with the nearest names, for an unknown
/// name.
View built_in_scene(const std::string& name);

}  // namespace fairlight
