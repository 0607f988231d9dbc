#include <iostream>

#include "core/star.hpp"

int main(int, char** argv) {
  const asterism::Star star = asterism::Star::parse(argv[1]);
  for (std::size_t arm = 0; arm < star.size(); ++arm) {
    std::cout << star.name(arm) << " is opposite " << star.name(star.opposite(arm)) << "\n";
  }
}
