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

void add_filters(std::vector<Claim>& claims) {
  const std::string source = "Ernst, Stamminger, Greiner 2006";
  add_law(claims, LawEstimand{"filter.box", "BoxFilter", source,
                              []<class Real>(std::type_identity<Real>) { return BoxFilter<Real>(Real(0.75)); },
                              SquareDomain{-0.75, 0.75}});
  add_law(claims, LawEstimand{"filter.tent", "TentFilter", source,
                              []<class Real>(std::type_identity<Real>) { return TentFilter<Real>{}; },
                              SquareDomain{-1, 1}});
  add_law(claims, gaussian_law<GaussianFilter>());
  add_law(claims,
          LawEstimand{"filter.blackman_harris", "BlackmanHarrisFilter", "Harris 1978",
                      []<class Real>(std::type_identity<Real>) { return BlackmanHarrisFilter<Real>(Real(1.5)); },
                      SquareDomain{-1.5, 1.5}, 10});
}

void add_apertures(std::vector<Claim>& claims) {
  add_law(claims, circular_aperture_law<CircularAperture>());
  claims.push_back(polygonal_aperture_claim<double>());
  claims.push_back(polygonal_aperture_claim<Packet>());
  add_mean(claims, polygon_second_moment(6));
  add_uniform_fields<double>(claims);
  add_uniform_fields<Packet>(claims);
}

void add_lenses(std::vector<Claim>& claims) {
  add_mean(claims, circle_of_confusion<CircularAperture, ThinLens>(3.5));
  add_mean(claims, circle_of_confusion<CircularAperture, ThinLens>(0.75));
  claims.push_back(focus_claim<double, ThinLens>());
  claims.push_back(focus_claim<Packet, ThinLens>());
}

void add_filter_moments(std::vector<Claim>& claims) {
  add_mean(claims, filter_moment("filter.box", "BoxFilter", 0.75 * 0.75 / 3, 0.75,
                                 []<class Real>(std::type_identity<Real>) { return BoxFilter<Real>(Real(0.75)); }));
  add_mean(claims, filter_moment("filter.tent", "TentFilter", 1.0 / 6, 1,
                                 []<class Real>(std::type_identity<Real>) { return TentFilter<Real>(); }));
  add_mean(claims, filter_moment("filter.gaussian", "GaussianFilter", cut_gaussian_moment(0.5, 1), 1,
                                 []<class Real>(std::type_identity<Real>) {
                                   return GaussianFilter<Real>(Real(0.5), Real(1));
                                 }));
  add_mean(claims, filter_moment(
                       "filter.blackman_harris", "BlackmanHarrisFilter", blackman_harris_moment(1.5), 1.5,
                       []<class Real>(std::type_identity<Real>) { return BlackmanHarrisFilter<Real>(Real(1.5)); }));
}

}  // namespace

void add_camera_claims(std::vector<Claim>& claims) {
  add_filter_moments(claims);
  add_filters(claims);
  add_apertures(claims);
  add_lenses(claims);
  add_mean(claims, pinhole_crossings());
  add_mean(claims, lens_crossings());
}

}  // namespace fairlight
