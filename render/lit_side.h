#pragma once

#include <cstddef>

#include <fairlight/render/scene.h>

namespace fairlight {

/// On which side of a surface all light is. A path that starts on the other side of it finds none.
enum class LitSide { either, inside, outside };

/// Where the luminaires of a scene are, if a sphere lets no light through and emits none itself: all of them wholly inside, or
/// all of them wholly outside. Either for other surfaces, for a sphere that a luminaire may cut, and in a scene without luminaires.
/// Domain   the index of a surface of the scene
LitSide lit_side(const Scene& scene, std::size_t surface);

/// Whether a surface may stand between a vertex of a path that finds light and a point that a luminaire shows to it. None may that
/// has both on the same side of it and is convex: a sphere that is lit inside, a rectangle to one side of whose plane there is no
/// surface, and the only luminaire.
/// Domain   the index of a surface of the scene
bool can_occlude(const Scene& scene, std::size_t surface);

}  // namespace fairlight
