#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/splitting.h>
#include <fairlight/estimators/stratification.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/lights_at_any_distance.h>
#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/signed_integrals.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

void add_signed_integrals(std::vector<Claim>& claims) {
  const auto add = [&](const std::string& component, const std::string& name, const auto& combine) {
    add_mean_over(claims, signed_coefficients(component), [=](const Values& values) {
      return signed_integral("signed." + name, component, values, combine);
    });
  };
  add("Importance", "importance", [](const auto& inner) { return inner; });
  for (const double q : {0.1, 0.7}) {
    add("Rouletted", q < 0.5 ? "roulette.rare" : "roulette",
        [q]<class Inner>(const Inner& inner) { return Rouletted<Inner, RussianRoulette>(inner, q); });
  }
  for (const double k : {0.3, 2.25}) {
    add("Splitting", k < 1 ? "splitting.fraction" : "splitting",
        [k]<class Inner>(const Inner& inner) { return Splitting<Inner>(inner, k); });
  }
  add("StratifiedMean", "stratified",
      []<class Inner>(const Inner& inner) { return StratifiedMean<Inner>(inner, 1, 7); });
  add_mean_over(claims, signed_coefficients("ControlVariate"),
                [](const Values& values) { return signed_control_variate<ControlVariate>(values); });
}

// Adds the rows of `make(name, values)` for each range of distances.
template <class Make>
void add_distances(std::vector<Claim>& claims, const std::string& name, const std::string& subject,
                   const Make& make) {
  for (const DistanceRange& range : distance_ranges) {
    add_mean_over(claims, drawn_distance(subject, range),
                  [=](const Values& values) { return make(name + "." + range.name, subject, values); });
  }
}

template <template <class> class Strategy>
void add_rectangle(std::vector<Claim>& claims, const std::string& family, const std::string& subject,
                   double share) {
  add_distances(claims, family + ".at_any_distance", subject, [=](auto name, auto light, const Values& values) {
    return rectangle_at_any_distance<Strategy>(name, light, share, values);
  });
}

template <template <class> class Strategy>
void add_sphere(std::vector<Claim>& claims, const std::string& family, const std::string& subject, double share) {
  add_distances(claims, family + ".at_any_distance", subject, [=](auto name, auto light, const Values& values) {
    return sphere_at_any_distance<Strategy>(name, light, share, values);
  });
}

template <class Real>
using ByArea = SphereByArea<Real>;
template <class Real>
using ByVisibleHemisphere = SphereByVisibleHemisphere<Real>;

}  // namespace

void add_whole_domain_claims(std::vector<Claim>& claims) {
  add_signed_integrals(claims);
  add_rectangle<RectangleByArea>(claims, "rectangle.by_area", "RectangleByArea", 1);
  add_rectangle<RectangleBySolidAngle>(claims, "rectangle.by_solid_angle", "RectangleBySolidAngle", 0);
  add_sphere<ByArea>(claims, "sphere_light.by_area", "SphereByArea", 1);
  add_sphere<ByVisibleHemisphere>(claims, "sphere_light.by_visible", "SphereByVisibleHemisphere", 0.5);
  add_sphere<SphereByCone>(claims, "sphere_light.by_cone", "SphereByCone", 0);
  add_picture_claims(claims);
}

}  // namespace fairlight
