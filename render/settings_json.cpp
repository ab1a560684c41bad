#include <cmath>
#include <stdexcept>
#include <type_traits>

#include <fairlight/render/settings.h>

namespace fairlight {
namespace {

template <class Settings, class Visit>
void for_each_setting(Settings& s, const Visit& visit) {
  visit("scene", s.scene);
  visit("width", s.width);
  visit("height", s.height);
  visit("real", s.real);
  visit("bounce", s.bounce);
  visit("direct", s.direct);
  visit("light_sampling", s.light_sampling);
  visit("which_light", s.which_light);
  visit("roulette", s.roulette);
  visit("roulette_depth", s.roulette_depth);
  visit("filter", s.filter);
  visit("random", s.random);
  visit("points", s.points);
  visit("max_depth", s.max_depth);
  visit("aperture", s.aperture);
  visit("focus", s.focus);
  visit("fov", s.fov);
}

// JSON stores null for a number that is not finite.
template <class Value>
void require_finite(const char* name, const Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    if (!std::isfinite(value))
      throw std::invalid_argument(std::string("the setting \"") + name +
                                  "\" must be a finite number (a negative one is the scene's own)");
  }
}

template <class Value>
bool holds(const nlohmann::json& json) {
  if constexpr (std::is_floating_point_v<Value>) return json.is_number();
  if constexpr (std::is_integral_v<Value>) return json.is_number_integer();
  return json.is_string();
}

template <class Value>
constexpr const char* kind = std::is_floating_point_v<Value> ? "a number"
                             : std::is_integral_v<Value>     ? "a whole number"
                                                             : "text";

}  // namespace

void check_finite(const RenderSettings& settings) {
  for_each_setting(settings, [](const char* name, const auto& value) { require_finite(name, value); });
}

void to_json(nlohmann::json& json, const RenderSettings& settings) {
  check_finite(settings);
  for_each_setting(settings, [&](const char* name, const auto& value) { json[name] = value; });
}

void from_json(const nlohmann::json& json, RenderSettings& settings) {
  for_each_setting(settings, [&](const char* name, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    const auto found = json.find(name);
    if (found == json.end()) throw std::invalid_argument(std::string("the setting \"") + name + "\" is missing");
    const bool is_held = holds<Value>(*found) && nlohmann::json(found->get<Value>()) == *found;
    if (!is_held)
      throw std::invalid_argument(std::string("the setting \"") + name + "\" is " + found->dump() +
                                  " (it must be " + kind<Value> + ")");
    found->get_to(value);
  });
}

}  // namespace fairlight
