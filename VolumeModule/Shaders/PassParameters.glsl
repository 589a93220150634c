// Nothing is passed: the fragment shader reads its parameters itself
// (Core/Recipe/FlatParameters.h).

void PassParameters() {}
