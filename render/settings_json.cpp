#include <cmath>
#include <stdexcept>
#include <type_traits>

#include <fairlight/render/nearest_names.h>
#include <fairlight/render/settings.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

template <class Settings, class Visit>
void for_each_setting(Settings& s, const Visit& visit) {
  const auto strategy = [&]<class Strategy>(Strategy& value) {
    visit(StrategyTable<std::remove_const_t<Strategy>>::setting, value);
  };
  visit("scene", s.scene);
  visit("width", s.width);
  visit("height", s.height);
  strategy(s.real);
  strategy(s.bounce);
  strategy(s.direct);
  strategy(s.light_sampling);
  strategy(s.which_light);
  strategy(s.roulette);
  visit("roulette_depth", s.roulette_depth);
  strategy(s.filter);
  strategy(s.random);
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

// A strategy is stored as its name, all other values as they are.
template <class Value>
nlohmann::json stored(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return name_of(value);
  else
    return value;
}

// Throws std::invalid_argument unless the JSON is a value of this type.
template <class Value>
void read(const char* name, const nlohmann::json& json, Value& value) {
  using Stored = std::conditional_t<std::is_enum_v<Value>, std::string, Value>;
  const bool is_held = holds<Stored>(json) && nlohmann::json(json.get<Stored>()) == json;
  if (!is_held) {
    throw std::invalid_argument(
        formatted("the setting \"%s\" is %s (it must be %s)", name, json.dump().c_str(), kind<Stored>));
  }
  if constexpr (std::is_enum_v<Value>) {
    const auto word = json.get<std::string>();
    const StrategyRow<Value>* row = find_strategy<Value>(word);
    if (row == nullptr) {
      const std::string hint = did_you_mean(word, strategy_names<Value>(), "fairlight render --help");
      throw std::invalid_argument(
          formatted("the setting \"%s\" is %s %s", name, json.dump().c_str(), hint.c_str()));
    }
    value = row->value;
  } else {
    json.get_to(value);
  }
}

}  // namespace

void check_finite(const RenderSettings& settings) {
  for_each_setting(settings, [](const char* name, const auto& value) { require_finite(name, value); });
}

void to_json(nlohmann::json& json, const RenderSettings& settings) {
  check_finite(settings);
  for_each_setting(settings, [&](const char* name, const auto& value) { json[name] = stored(value); });
}

void from_json(const nlohmann::json& json, RenderSettings& settings) {
  for_each_setting(settings, [&](const char* name, auto& value) {
    const auto found = json.find(name);
    if (found == json.end()) throw std::invalid_argument(formatted("the setting \"%s\" is missing", name));
    read(name, *found, value);
  });
}

}  // namespace fairlight
