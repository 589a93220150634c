#include "Viewer/Model/Gesture.h"

namespace varimarch
{

int NewGesture()
{
  static int last = 0;
  return ++last;
}

}
