#pragma once

#include <cstddef>

#include <fairlight/render/scene.h>

namespace fairlight {

/// The side of a surface on which all luminaires are. A path that starts on the other side finds no
/// light.
enum class LitSide { either, inside, outside };

/// `inside` or `outside` if all luminaires lie wholly on that side of an opaque sphere that does
/// not emit. `either` for other surfaces, for a sphere that a luminaire may intersect, and for a
/// scene without luminaires.
/// Domain   the index of a surface of the scene
LitSide lit_side(const Scene& scene, std::size_t surface);

/// Whether a surface can occlude a luminaire's point that faces a vertex of a path on the lit side.
/// A convex surface with both on the same side cannot: a sphere lit inside, a rectangle with no
/// surface beyond its plane on one side, and the only luminaire.
/// Domain   the index of a surface of the scene
bool can_occlude(const Scene& scene, std::size_t surface);

}  // namespace fairlight
