#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/camera.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/filters.h>
#include <fairlight/validation/claims/lens.h>

namespace fairlight {

namespace {

// The law of a filter, and its mean squared offset along an axis.
void add_filter(std::vector<Claim>& claims, const auto& law, double moment) {
  add_mean(claims, filter_moment(law.name, law.subject, moment, law.domain.high, law.make));
  add_law(claims, law);
}

void add_filters(std::vector<Claim>& claims) {
  const std::string source = "Ernst, Stamminger, Greiner 2006";
  add_filter(claims,
             LawEstimand{"filter.box", "BoxFilter", source, component<BoxFilter>(0.75), SquareDomain{-0.75, 0.75}},
             0.75 * 0.75 / 3);
  add_filter(claims, LawEstimand{"filter.tent", "TentFilter", source, component<TentFilter>(), SquareDomain{-1, 1}},
             1.0 / 6);
  add_filter(claims, gaussian_law<GaussianFilter>(), cut_gaussian_moment(0.5, 1));
  add_filter(claims,
             LawEstimand{"filter.blackman_harris", "BlackmanHarrisFilter", "Harris 1978",
                         component<BlackmanHarrisFilter>(1.5), SquareDomain{-1.5, 1.5}, 10},
             blackman_harris_moment(1.5));
}

void add_apertures(std::vector<Claim>& claims) {
  add_law(claims, circular_aperture_law<CircularAperture>());
  claims.push_back(polygonal_aperture_claim<double>());
  claims.push_back(polygonal_aperture_claim<Packet>());
  add_mean(claims, polygon_second_moment(6));
  add_constant(claims, uniform_field_of_disk<CircularAperture>());
  add_constant(claims, uniform_field_of_pentagon());
}

void add_lenses(std::vector<Claim>& claims) {
  add_mean(claims, circle_of_confusion<CircularAperture, ThinLens>(3.5));
  add_mean(claims, circle_of_confusion<CircularAperture, ThinLens>(0.75));
  add_constant(claims, lens_focus<ThinLens>());
}

}  // namespace

void add_camera_claims(std::vector<Claim>& claims) {
  add_filters(claims);
  add_apertures(claims);
  add_lenses(claims);
  add_mean(claims, pinhole_crossings());
  add_mean(claims, lens_crossings());
}

}  // namespace fairlight
