// Where a ray first has an opacity: it is marched in pieces, and the piece in which it gets there
// in smaller ones.

const int Pieces = 64;
const int PiecesOfPiece = 16;
const float Nowhere = 3.0e38;

float FirstWithOpacity(Ray ray, Interval inside, float opacity)
{
  Accumulation sum = BlendBegin();
  float t = inside.enter;
  float pieceMm = (inside.exit - inside.enter) / float(Pieces);
  bool small = false;
  float found = Nowhere;
  for (int piece = 0; piece < Pieces + PiecesOfPiece + 1 && t < inside.exit; ++piece)
  {
    float end = min(t + pieceMm, inside.exit);
    Accumulation next = MarchCropped(ray, Interval(t, end), sum);
    if (BlendResult(next).a < opacity)
    {
      sum = next;
      t = end;
    }
    else if (small)
    {
      found = 0.5 * (t + end);
      break;
    }
    else
    {
      pieceMm /= float(PiecesOfPiece);
      small = true;
    }
  }
  return found;
}
