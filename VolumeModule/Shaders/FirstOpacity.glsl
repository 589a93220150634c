// Where a ray first has an opacity: it is marched in pieces, and that in which it gets there is
// halved until the opacity is taken as linear. Pieces begin behind what is invisible.

const float Nowhere = 3.0e38;
const float StepsPerPiece = 8.0;
const float ShortestVoxels = 0.25; // piece

struct Located
{
  float t;          // Nowhere if it never has it
  float marched;    // up to here, at most t, in whole pieces,
  Accumulation sum; // to this
};

Located Locate(Ray ray, Interval inside, float opacity)
{
  Accumulation sum = BlendBegin();
  float t = inside.enter;
  float end = inside.exit;
  float endOpacity = 0.0; // where it is enough; 0 while that is not known
  float shortestMm = ShortestVoxels / length(ray.directionGrid);
  float shortest = 0.0;
  Located before = Located(Nowhere, t, sum);
  for (int index = 0; index < mostSegments && end - t > shortest; ++index)
  {
    bool isHalf = endOpacity > 0.0;
    Interval piece = Interval(t, 0.5 * (t + end));
    if (!isHalf)
    {
      piece = NextSegment(ray, inside, t, index, StepsPerPiece * stepMm, BlendState(sum));
      piece.exit = min(piece.exit, inside.exit);
    }
    // With what is left out in front: its length counts in some sums, but nothing is seen there.
    Accumulation next = MarchCropped(ray, Interval(t, piece.exit), sum);
    float reached = BlendResult(next).a;
    if (reached < opacity || !(piece.enter < piece.exit))
    {
      sum = next;
      t = piece.exit;
      before = isHalf ? before : Located(Nowhere, t, sum);
    }
    else
    {
      t = piece.enter;
      end = piece.exit;
      endOpacity = reached;
      shortest = shortestMm;
    }
  }
  float begun = BlendResult(sum).a;
  float along = clamp((opacity - begun) / max(endOpacity - begun, 1e-30), 0.0, 1.0);
  before.t = endOpacity > 0.0 ? mix(t, end, along) : Nowhere;
  return before;
}
