// Steps by the field of variations S of Banquero, Ortiz and Rossi, "Realtime volume render en
// videojuegos" (2016), equation 3: from t, the ray goes on by the distance that is stored for the
// nearest voxel, in voxels along the ray, however long a plain step is.

Interval NextOfField(Ray ray, Interval inside, float t, float plainMm)
{
  float voxels = 255.0 * textureLod(fieldTexture, PositionTexture(ray, t), 0.0).r;
  return Interval(t, t + voxels / length(ray.directionGrid));
}

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  Interval next = NextOfField(ray, inside, t, plainMm);
  return Interval(t, t + PlainMm(index, next.exit - t));
}
