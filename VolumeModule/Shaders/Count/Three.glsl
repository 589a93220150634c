// How many materials are mixed.

const int PartCount = 3;
