// Lights are points.

float MeanTransmitted(vec3 originGrid, vec3 towards, float farMm, float coneHeight)
{
  return Transmitted(originGrid, towards, farMm);
}
