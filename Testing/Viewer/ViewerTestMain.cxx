// main() for tests of the viewer: widgets are rendered offscreen unless a platform is requested.

#include "LeaksOfOthers.h"
#include "PrivateSettings.h"

#include <gtest/gtest.h>

#include <QApplication>

#include <cstdlib>

int main(int argumentCount, char** arguments)
{
  testing::InitGoogleTest(&argumentCount, arguments);
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  const PrivateSettings settings;
  QApplication application(argumentCount, arguments);
  return RUN_ALL_TESTS();
}
