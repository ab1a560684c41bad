#pragma once

#include <vector>

#include <fairlight/validation/claim.h>

namespace fairlight {

/// The rows of the registry, by what they are about; each adds its own.
void add_direction_claims(std::vector<Claim>& claims);
void add_microfacet_claims(std::vector<Claim>& claims);
void add_material_claims(std::vector<Claim>& claims);
void add_light_claims(std::vector<Claim>& claims);
void add_combinator_claims(std::vector<Claim>& claims);
void add_random_claims(std::vector<Claim>& claims);
void add_camera_claims(std::vector<Claim>& claims);
void add_allocation_claims(std::vector<Claim>& claims);
void add_second_order_claims(std::vector<Claim>& claims);
void add_scene_claims(std::vector<Claim>& claims);
void add_built_in_scene_claims(std::vector<Claim>& claims);

/// All of them, for packets as wide as this is compiled for.
inline void add_claims(std::vector<Claim>& claims) {
  for (const auto add : {add_random_claims, add_direction_claims, add_microfacet_claims, add_material_claims,
                         add_light_claims, add_combinator_claims, add_camera_claims, add_allocation_claims,
                         add_second_order_claims, add_scene_claims, add_built_in_scene_claims}) {
    add(claims);
  }
}

}  // namespace fairlight
