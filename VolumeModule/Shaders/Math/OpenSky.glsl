// Ambient occlusion: Documentation/Mathematics.md. Needs BlinnPhong.glsl.

// How much scalars change over a voxel along a gradient, which is a difference over two voxels.
float ChangePerVoxel(vec3 gradient)
{
  return 0.5f * length(gradient);
}

// The way from a surface to the place that sees what is around it, two voxels along the gradient
// [grid]: to the side on which there would be less matter if scalars went on as they change here,
// and down where there would be the same but for a hundredth, so that rounding decides nothing.
// @param above, below  the extinctions of the scalars a voxel up and down the gradient
vec3 WayOutside(vec3 gradient, float above, float below)
{
  float way = 2.0f * InverseLength(gradient);
  return (above < 0.99f * below ? way : -way) * gradient;
}

// The part of its light that a place keeps. Matter that takes light gives back a part of it.
// @param visible  the part of the light from all around that reaches the place, [0, 1]
// @param strength  of ambient occlusion, (0, 1]
float KeptLight(float visible, float strength)
{
  return visible / (visible + strength * (1.0f - visible));
}
