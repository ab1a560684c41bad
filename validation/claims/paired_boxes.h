#pragma once

#include <fairlight/validation/claims/paired_paths.h>
#include <fairlight/validation/claims/scene_relations.h>

namespace fairlight {

/// The Cornell boxes where strategies are compared along the same paths.

/// The box of the paper, up to four bounces, against its light by cone alone.
/// Bound    for a vertex, in grey: by cone S f Le <= 2.49 (see box_means), also for a bounce that
///          shares; by area A f Le / d^2 <= 9 pi 400 0.75 / (pi 15^2) = 12; by the visible
///          hemisphere half of this. Four vertices, with the albedo 0.8 from one to the next.
inline constexpr double four_vertices = 1 + 0.8 + 0.64 + 0.512;
inline PairedPaths in_the_box(const std::string& name, LightPoints sampling, DirectLighting direct,
                              double brightest) {
  return {name,
          "cornell-simple",
          related_settings(sampling, WhichLight::all, 4, direct),
          related_settings(LightPoints::cone, WhichLight::all, 4),
          -2.49 * four_vertices,
          brightest * four_vertices};
}
inline PairedPaths box_by_area() {
  return in_the_box(name_of(LightPoints::area), LightPoints::area, DirectLighting::light, 12);
}
inline PairedPaths box_by_visible() {
  return in_the_box(name_of(LightPoints::visible), LightPoints::visible, DirectLighting::light, 6);
}
inline PairedPaths box_shared() {
  return in_the_box(name_of(DirectLighting::mis), LightPoints::cone, DirectLighting::mis, 2.49);
}

/// The measured box, up to three bounces, against its light by solid angle alone. By area alone the
/// range would be three million: a point next to the lamp, h = 0.1 mm under the ceiling, brings A f
/// Le / h^2.
/// Bound    S f Le <= 15.8 (see split_box_light). Where shadow rays and bounces share, each brings
///          f Le cos / (p_l + p_b) <= albedo Le = 7.9, by any sampling of the light.
inline PairedPaths measured_box(const std::string& name, LightPoints sampling, double brightest) {
  constexpr double vertices = 1 + 0.725 + 0.526;
  return {name,
          "cornell-original",
          related_settings(sampling, WhichLight::all, 3, DirectLighting::mis),
          related_settings(LightPoints::solid_angle, WhichLight::all, 3),
          -15.8 * vertices,
          brightest * vertices};
}
inline PairedPaths measured_box_shared() {
  return measured_box(name_of(DirectLighting::mis), LightPoints::solid_angle, 7.9);
}
inline PairedPaths measured_box_by_area() {
  return measured_box(name_of(LightPoints::area), LightPoints::area, 15.8);
}

inline PartMeans whole_of(double mean) { return {"picture", "over the picture", {mean}}; }
inline PartMeans border_of(double mean) { return {"border", "over the outermost 8 pixels of 256", {mean}}; }
inline PartMeans box_picture() { return whole_of(0.21); }
inline PartMeans box_border() { return border_of(0.16); }
inline PartMeans measured_box_picture() { return whole_of(0.049); }
inline PartMeans measured_box_border() { return border_of(0.013); }
/// The means in grey, row by row.
inline PartMeans box_tiles() {
  return {"tiles",
          "in each of 8 x 8 tiles",
          {0.130, 0.154, 0.191, 0.235, 0.235, 0.193, 0.154, 0.128, 0.203, 0.194, 0.337, 0.631, 0.635,
           0.338, 0.195, 0.203, 0.215, 0.125, 0.173, 0.192, 0.193, 0.175, 0.127, 0.215, 0.202, 0.129,
           0.176, 0.200, 0.204, 0.184, 0.133, 0.200, 0.169, 0.119, 0.278, 0.212, 0.194, 0.277, 0.137,
           0.164, 0.135, 0.098, 0.266, 0.233, 0.232, 0.229, 0.111, 0.125, 0.121, 0.112, 0.153, 0.207,
           0.199, 0.096, 0.084, 0.079, 0.183, 0.231, 0.260, 0.275, 0.253, 0.171, 0.146, 0.139}};
}
/// Quarters, as the range makes smaller tiles too expensive: the darkest of 64 shows 0.005.
inline PartMeans measured_box_quarters() { return {"quarters", "in each quarter", {0.058, 0.054, 0.038, 0.033}}; }

}  // namespace fairlight
