#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/scene_relations.h>

namespace fairlight {

namespace {

void add_same_paths(std::vector<Claim>& claims, const RelatedViews& views) {
  claims.push_back(same_paths<double>(views));
  claims.push_back(same_paths<Packet>(views));
}

template <class Numbers>
void add_twice_the_samples(std::vector<Claim>& claims, RandomNumbers kind, const std::string& subject) {
  claims.push_back(twice_the_samples<double, Numbers>(kind, subject, two_lights_samples()));
  claims.push_back(twice_the_samples<Packet, Numbers>(kind, subject, two_lights_samples()));
}

}  // namespace

void add_relation_claims(std::vector<Claim>& claims) {
  // Scenes with all kinds of surfaces, and with rectangles.
  for (const std::string scene : {"cornell-materials", "cornell-original"}) {
    add_same_paths(claims, smaller(scene));
    add_same_paths(claims, larger(scene));
  }
  // Scenes with diffuse surfaces. Gloss may reflect so little that its digits are lost at the lower
  // end of the range of floats.
  for (const std::string scene : {"cornell-simple", "cornell-original"}) {
    add_same_paths(claims, brighter(scene));
    add_same_paths(claims, darker(scene));
  }
  claims.push_back(mean_claim_alone<double>(far_away(far_for_doubles)));
  claims.push_back(mean_claim<Packet>(far_away(far_for_floats)));
  add_independent_mean(claims, turned_floor());
  add_independent_mean(claims, upended_floor());
  add_independent_mean(claims, reversed_lights());
  claims.push_back(mean_claim<Packet>(turned_box()));  // in packets only, as it takes seconds in double
  for (const WhichLight which : {WhichLight::all, WhichLight::one}) {
    add_independent_mean(claims, split_lamp(which));
    claims.push_back(mean_claim<Packet>(split_box_light(which)));
  }
  add_twice_the_samples<PaddedSobol>(claims, RandomNumbers::sobol, "PaddedSobol");
  add_twice_the_samples<PaddedStrata>(claims, RandomNumbers::stratified, "PaddedStrata");
}

}  // namespace fairlight
