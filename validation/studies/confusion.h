#pragma once

#include <fairlight/render/camera.h>
#include <fairlight/validation/studies/study.h>

namespace fairlight {

/// Where a camera sees a point: in pixels from the top left of a picture.
struct SeenAt {
  double x, y;
  double distance;  ///< along the axis [m]
};
SeenAt seen_at(const CameraSettings& camera, const Vec3<double>& point, int width, int height);

/// The radius of the circle of confusion at a distance [m] along the axis, in pixels of a picture of
/// that height: R |d - f| / (f d) on the image plane at distance 1.
/// Source   Cook, Porter, Carpenter 1984; estimators/lens.h
double circle_of_confusion(const CameraSettings& camera, double distance, int height);

/// The same radius, measured: the middle pixel's rays, through random points of the lens, cross the
/// plane at that distance in a disk; its radius is sqrt(2) times the root mean square distance from
/// where the pinhole's ray crosses.
Measured measured_confusion(const CameraSettings& camera, double distance, int height, const StudyOptions& options,
                            const std::string& purpose);

}  // namespace fairlight
