// The fragment shader reads its parameters itself; see Core/Recipe/FlatParameters.h.

void PassParameters() {}
