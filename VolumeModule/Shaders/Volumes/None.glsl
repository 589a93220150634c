// The empty sum, before the first of several overlapping volumes. Where volumes overlap, their
// extinctions and emissions add up in any order, like those of mixed particles.

const float Never = 3.0e38; // beyond the end of every ray [mm]

// Emission (r,g,b) [1/mm] and extinction [1/mm] in the middles of four equal parts of a segment.
struct Mixture
{
  vec4 first;
  vec4 second;
  vec4 third;
  vec4 fourth;
};

Accumulation March(Ray ray, Interval inside, Accumulation sum);

Interval BeginVolumesBefore(Ray ray, Interval inside)
{
  return Interval(Never, -Never);
}

float NextFaceBefore(float t)
{
  return Never;
}

Interval NextVisibleBefore(float t, int index, float blendState)
{
  return Interval(Never, Never);
}

bool ReadSegmentBefore(Interval segment)
{
  return false;
}

Mixture MixtureOfBefore(Interval segment)
{
  return Mixture(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
}
