#pragma once

#include <fairlight/render/built_in_scenes.h>

namespace fairlight {

/// The box of `cornell-simple` without its light.
View dark_box();

/// The box with one spherical light of this radius [m] at its usual place; 1.5 m is the paper's. All
/// have the power of that one, so that pictures are equally bright.
View box_with_light(double radius);

/// The box with n spherical lights of 0.15 m and unequal powers, on a grid below the ceiling. Their
/// total power is that of the paper's light.
View box_with_lights(int n);

}  // namespace fairlight
