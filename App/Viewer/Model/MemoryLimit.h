#ifndef Varimarch_Viewer_MemoryLimit_h
#define Varimarch_Viewer_MemoryLimit_h

namespace varimarch
{

/// The memory that the user lets the program use for volumes [GB], kept in the settings; 0: all of
/// the computer's.
int ChosenMemoryGigabytes();
void ChooseMemoryGigabytes(int gigabytes);

}

#endif
