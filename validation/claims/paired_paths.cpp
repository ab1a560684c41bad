#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/paired_boxes.h>

namespace fairlight {
namespace {

// Margins: 2 % for tiles and the border. For pictures at most 0.2 % of their mean, half of which is
// the light itself. In the measured box 0.2 % or 0.4 % of what the surfaces reflect, which margins
// are relative to.
void add_box(std::vector<Claim>& claims) {
  const PartMeans picture = box_picture(), border = box_border(), tiles = box_tiles();
  claims.push_back(presumed_light<WholePicture>(box_shared(), picture));
  claims.push_back(presumed_light<PictureBorder>(box_shared(), border));
  claims.push_back(presumed_light<PictureTiles<8>>(box_shared(), tiles));
  for (const PairedPaths& paths : {box_by_visible(), box_shared()}) {
    claims.push_back(paired_claim<WholePicture>(paths, picture, 2));
    claims.push_back(paired_claim<PictureBorder>(paths, border, 20));
    claims.push_back(paired_claim<PictureTiles<8>>(paths, tiles, 20));
  }
  // Half of the sampled points face away, so the margin is wider.
  claims.push_back(paired_claim<WholePicture>(box_by_area(), picture, 4));
  claims.push_back(paired_claim<PictureBorder>(box_by_area(), border, 20));
}

void add_measured_box(std::vector<Claim>& claims) {
  const PartMeans picture = measured_box_picture(), border = measured_box_border(),
                  quarters = measured_box_quarters();
  claims.push_back(presumed_light<WholePicture>(measured_box_shared(), picture));
  claims.push_back(presumed_light<PictureBorder>(measured_box_shared(), border));
  claims.push_back(presumed_light<PictureTiles<2>>(measured_box_shared(), quarters));
  for (const PairedPaths& paths : {measured_box_shared(), measured_box_by_area()}) {
    claims.push_back(paired_claim<WholePicture>(paths, picture, 4));
    claims.push_back(paired_claim<PictureBorder>(paths, border, 20));
    claims.push_back(paired_claim<PictureTiles<2>>(paths, quarters, 20));
  }
}

}  // namespace

void add_paired_path_claims(std::vector<Claim>& claims) {
  add_box(claims);
  add_measured_box(claims);
}

}  // namespace fairlight
