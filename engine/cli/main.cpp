#include <cstdio>

int main() {
  std::puts("flyrock " FLYROCK_VERSION);
  return 0;
}
