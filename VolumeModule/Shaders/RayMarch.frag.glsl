#include "Math/IntersectBox.glsl"
#include "Math/Planes.glsl"
// The ray of each pixel: the part of it that is inside the volume, and the colour to draw for it.

// The homogeneous start and the direction of a ray are affine in the pixel's position; see
// Core/Geometry/PixelRays.h.

out vec4 fragOutput0;

Ray PixelRay()
{
  vec2 pixel = RayPixel() * viewportPixelsInverse * 2.0 - 1.0;
  vec4 start = rayStartGrid[0] + pixel.x * rayStartGrid[1] + pixel.y * rayStartGrid[2];
  vec3 direction =
    rayDirectionGrid[0] + pixel.x * rayDirectionGrid[1] + pixel.y * rayDirectionGrid[2];
  Ray ray;
  ray.originGrid = start.xyz / start.w;
  ray.directionGrid = direction / length(worldFromGrid * direction);
  ray.originTexture = (ray.originGrid - firstVoxelGrid + 0.5) * voxelCountInverse;
  ray.directionTexture = ray.directionGrid * voxelCountInverse;
  return ray;
}

Interval InsideBox(Ray ray, vec3 lowerGrid, vec3 upperGrid)
{
  vec2 inside = IntersectBox(ray.originGrid, SafeInverse(ray.directionGrid), lowerGrid, upperGrid);
  // The near plane cuts the box when the camera is close to it or inside.
  inside = CutByPlane(inside, BeyondPlane(nearPlaneGrid, ray.originGrid),
    ApproachToPlane(nearPlaneGrid, ray.directionGrid));
  inside = CutByPlane(inside, BeyondPlane(farPlaneGrid, ray.originGrid),
    ApproachToPlane(farPlaneGrid, ray.directionGrid));
  return Clipped(ray, Interval(inside.x, min(inside.y, DepthLimit(ray))));
}

Interval InsideOf(Ray ray)
{
  return Spanned(ray, InsideBox(ray, boxLowerGrid, boxUpperGrid));
}

void main()
{
  Ray ray = PixelRay();
  Interval inside = InsideOf(ray);
  if (!(inside.enter < inside.exit))
  {
    discard;
  }
  fragOutput0 = DrawnRay(ray, inside);
}
