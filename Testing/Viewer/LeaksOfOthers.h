#ifndef Varimarch_Testing_LeaksOfOthers_h
#define Varimarch_Testing_LeaksOfOthers_h

// Suppressions for the sanitizer build: leaks of an empty Qt application.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:libQt5Gui.so\nleak:libQt5Core.so\nleak:libqoffscreen.so\nleak:libQt5XcbQpa.so\n"
         "leak:libfontconfig.so\n";
}

#endif
