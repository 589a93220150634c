#ifndef Varimarch_Readers_PageGuard_h
#define Varimarch_Readers_PageGuard_h

#include <cstddef>

// Addresses of mapped files in which a failure to read a page must not end the program. The system
// reports such a failure by the signal SIGBUS, whose action belongs to the whole process: it is
// taken over when the first addresses are guarded, and passes on what happens elsewhere.

namespace varimarch
{

/// Guards addresses. Pages that cannot be read are replaced by pages of zeros.
/// @param descriptor  the file that is mapped there, open until GuardNoMore
/// @param offset      offset in the file of the first page
/// @return the number of the guard; -1 if there are too many
int GuardPages(char* pages, std::size_t byteCount, int descriptor, std::size_t offset);

/// True if a page was replaced.
bool HasReplacedPages(int guard);

void GuardNoMore(int guard);

}

#endif
