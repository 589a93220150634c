// Selection: draws the colour that stands for this volume wherever it is visible.

vec4 DrawnRay(Ray ray, Interval inside)
{
  if (!(BlendResult(MarchCropped(ray, inside, BlendBegin())).a > leastOpacity))
  {
    discard;
  }
  return vec4(propColor, 1.0);
}
