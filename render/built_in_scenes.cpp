#include <stdexcept>
#include <utility>

#include <fairlight/render/cornell.h>

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
  std::string message = "there is no scene \"" + name + "\" (choose one of:";
  for (const auto& [known, make] : scenes) {
    if (name == known) return make();
    message += std::string(" ") + known;
  }
  throw std::invalid_argument(message + ")");
}

}  // namespace fairlight
