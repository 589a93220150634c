// The phase function of Henyey and Greenstein, "Diffuse radiation in the galaxy" (Astrophysical
// Journal 93, 1941), with a mean of 1 over the sphere.

// @param cosine  of the angle by which light is turned: 1 if it goes straight on
// @param anisotropy  mean of this cosine, inside (-1, 1)
float HenyeyGreenstein(float cosine, float anisotropy)
{
  float squared = anisotropy * anisotropy;
  float distance = 1.0f + squared - 2.0f * anisotropy * cosine;
  return (1.0f - squared) / (distance * sqrt(distance));
}
