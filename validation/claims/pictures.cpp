#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/edge_pictures.h>
#include <fairlight/validation/claims/floor_pictures.h>
#include <fairlight/validation/claims/picture_covariances.h>

namespace fairlight {

// Whole pictures, pixel by pixel, through the renderer as it is shipped.
void add_whole_picture_claims(std::vector<Claim>& claims) {
  for (const FloorPicture& picture : floor_pictures()) claims.push_back(floor_picture(picture));
  for (const EdgePicture& picture : edge_pictures()) claims.push_back(edge_picture(picture));
  add_picture_covariances(claims);
}

}  // namespace fairlight
