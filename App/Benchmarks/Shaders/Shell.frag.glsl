// A spherical shell around the eye. The triangles only cover its pixels: each fragment is moved
// along its ray onto the sphere, so that no mesh is needed.

uniform float sliceMm;  // length that a shell stands for [mm]
uniform float radiusMm; // radius of the shell [mm]
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  vec3 directionGrid = AwayFromEye(positionGrid);
  vec3 onSphere = eyeGrid.xyz + radiusMm * directionGrid;
  if (any(lessThan(onSphere, vec3(0.0))) || any(greaterThan(onSphere, boxUpperGrid)))
  {
    discard;
  }
  fragOutput0 = SampleColor(onSphere, directionGrid, sliceMm);
}
