// Steps by the field of variations S of Banquero, Ortiz and Rossi, "Realtime volume render en
// videojuegos" (2016), equation 3: from t, the ray goes on by the distance that is stored for the
// nearest voxel, in voxels along the ray, however long a plain step is.

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  float voxels = 255.0 * textureLod(fieldTexture, PositionTexture(ray, t), 0.0).r;
  return Interval(t, t + PlainMm(index, voxels / length(ray.directionGrid)));
}
