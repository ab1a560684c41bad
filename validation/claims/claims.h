#pragma once

#include <vector>

#include <fairlight/validation/checks/claim.h>

namespace fairlight {

/// Add the rows of the registry, by topic.
void add_direction_claims(std::vector<Claim>& claims);
void add_direction_domain_claims(std::vector<Claim>& claims);
void add_microfacet_claims(std::vector<Claim>& claims);
void add_material_claims(std::vector<Claim>& claims);
void add_light_claims(std::vector<Claim>& claims);
void add_light_domain_claims(std::vector<Claim>& claims);
void add_triangle_claims(std::vector<Claim>& claims);
void add_combinator_claims(std::vector<Claim>& claims);
void add_combinator_domain_claims(std::vector<Claim>& claims);
void add_random_claims(std::vector<Claim>& claims);
void add_camera_claims(std::vector<Claim>& claims);
void add_allocation_claims(std::vector<Claim>& claims);
void add_second_order_claims(std::vector<Claim>& claims);
void add_scene_claims(std::vector<Claim>& claims);
void add_closed_scene_claims(std::vector<Claim>& claims);
void add_built_in_scene_claims(std::vector<Claim>& claims);
void add_scene_strategy_claims(std::vector<Claim>& claims);
void add_relation_claims(std::vector<Claim>& claims);
void add_paired_path_claims(std::vector<Claim>& claims);
void add_whole_domain_claims(std::vector<Claim>& claims);
void add_whole_picture_claims(std::vector<Claim>& claims);

/// Adds all rows, each with the name of its file, for packets of the width that this is compiled
/// for.
inline void add_claims(std::vector<Claim>& claims) {
  struct Topic {
    const char* file;
    void (*add)(std::vector<Claim>& claims);
  };
  for (const Topic& topic : {Topic{"random.cpp", add_random_claims},
                             {"directions.cpp", add_direction_claims},
                             {"direction_domains.cpp", add_direction_domain_claims},
                             {"microfacet.cpp", add_microfacet_claims},
                             {"materials.cpp", add_material_claims},
                             {"lights.cpp", add_light_claims},
                             {"light_domains.cpp", add_light_domain_claims},
                             {"triangles.cpp", add_triangle_claims},
                             {"combinators.cpp", add_combinator_claims},
                             {"combinator_domains.cpp", add_combinator_domain_claims},
                             {"cameras.cpp", add_camera_claims},
                             {"allocation.cpp", add_allocation_claims},
                             {"second_order.cpp", add_second_order_claims},
                             {"scenes.cpp", add_scene_claims},
                             {"closed_scenes.cpp", add_closed_scene_claims},
                             {"built_in_scenes.cpp", add_built_in_scene_claims},
                             {"scene_strategies.cpp", add_scene_strategy_claims},
                             {"relations.cpp", add_relation_claims},
                             {"paired_paths.cpp", add_paired_path_claims},
                             {"whole_domains.cpp", add_whole_domain_claims},
                             {"pictures.cpp", add_whole_picture_claims}}) {
    const std::size_t before = claims.size();
    topic.add(claims);
    for (std::size_t i = before; i < claims.size(); ++i) claims[i].file = topic.file;
  }
}

}  // namespace fairlight
