#include <stdexcept>
#include <utility>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/render/nearest_names.h>

namespace fairlight {
namespace {

constexpr std::pair<const char*, View (*)()> scenes[] = {
    {"cornell-simple", cornell_simple},
    {"cornell-complex", cornell_complex},
    {"cornell-materials", cornell_materials},
    {"cornell-original", cornell_original},
    {"hallway", hallway},
    {"many-lights", many_lights},
};

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : scenes) names.emplace_back(name);
  return names;
}

View built_in_scene(const std::string& name) {
  for (const auto& [known, make] : scenes) {
    if (name == known) return make();
  }
  throw std::invalid_argument("there is no scene \"" + name + "\" " +
                              did_you_mean(name, scene_names(), "fairlight scenes"));
}

}  // namespace fairlight
