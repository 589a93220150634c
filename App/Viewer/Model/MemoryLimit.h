#ifndef Varimarch_Viewer_MemoryLimit_h
#define Varimarch_Viewer_MemoryLimit_h

namespace varimarch
{

struct FileSource;

/// The memory that the user lets the program use for volumes [GB], kept in the settings; 0: all of
/// the computer's.
int ChosenMemoryGigabytes();
void ChooseMemoryGigabytes(int gigabytes);

/// A file that is to be read within that memory, unless it states its own. Scenes do not keep the
/// user's, which belongs to this computer.
FileSource WithinMemory(FileSource file);

}

#endif
