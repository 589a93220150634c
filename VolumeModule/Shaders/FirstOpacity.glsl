// Finds the position at which a ray reaches an opacity. The ray is marched in pieces, which begin
// behind invisible parts. The piece in which the ray reaches the opacity is halved until the
// opacity can be taken as linear.

const float Nowhere = 3.0e38;
const float StepsPerPiece = 8.0;
const float ShortestPiece = 0.25; // length of the shortest piece

struct Located
{
  float t;          // Nowhere if the ray never reaches the opacity
  float marched;    // end of the last whole piece in front of t
  Accumulation sum; // state of the ray at `marched`
};

Located Locate(Ray ray, Interval inside, float opacity)
{
  Accumulation sum = BlendBegin();
  float t = inside.enter;
  float end = inside.exit;
  float endOpacity = 0.0; // opacity at `end`; 0 as long as it is not known
  float shortestMm = ShortestPiece / length(ray.directionGrid);
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
    // The invisible part in front is marched too, because some blend modes count its length.
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
