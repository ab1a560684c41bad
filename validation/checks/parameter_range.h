#pragma once

#include <string>

namespace fairlight {

/// A range of a component's parameter. A claim draws a value from it in every run, from the seed.
/// Low and high may be equal: a corner.
struct ParameterRange {
  enum class Law { uniform, logarithmic };

  std::string component;  ///< a type name, for example "RectangleLight"
  std::string parameter;  ///< for example "distance"; parameter_domains() has its unit
  double low, high;
  Law law = Law::uniform;
};

}  // namespace fairlight
