#include "March/SharedFacts.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Calls functions for all facts: of numbers of which the least counts, of numbers of which the
// greatest counts, of conditions that one part suffices for, and of conditions that all must meet.
// A new fact does not compile until it is here.
template <class Facts, class Merge>
void ForEachFact(Facts& facts, Merge& merge)
{
  auto& [limit, range, firstMm, usual, choosesIntegration, preIntegratesByTable, hasLight, isShaded,
    looksForPeaks, hasNarrowPeaks, losesByTable, hasNodesInTable, mayPreIntegrate, tracesLight,
    keepsLight, lightOfLimit, preIntegrationCost] = facts;
  auto& [percentile999, largest] = limit;
  auto& [coarsest, finest, isOfHalfOctaves, supposedOrder] = range;
  merge.Least(percentile999);
  merge.Least(largest);
  merge.Least(coarsest);
  merge.Greatest(finest);
  merge.IfAny(isOfHalfOctaves);
  merge.Least(supposedOrder);
  merge.Least(firstMm);
  merge.Least(usual);
  merge.IfAll(choosesIntegration);
  merge.IfAny(preIntegratesByTable);
  merge.IfAny(hasLight);
  merge.IfAny(isShaded);
  merge.IfAny(looksForPeaks);
  merge.IfAny(hasNarrowPeaks);
  merge.IfAny(losesByTable);
  merge.IfAny(hasNodesInTable);
  merge.IfAll(mayPreIntegrate);
  merge.IfAny(tracesLight);
  merge.IfAny(keepsLight);
  merge.Least(lightOfLimit);
  merge.Greatest(preIntegrationCost);
}

// Appends facts to numbers.
struct FactsToNumbers
{
  std::vector<double> numbers;

  template <class Number>
  void Least(Number number)
  {
    this->numbers.push_back(double(number));
  }
  void Greatest(double number) { this->numbers.push_back(-number); }
  void IfAny(bool holds) { this->numbers.push_back(varimarch::IfAny(holds)); }
  void IfAll(bool holds) { this->numbers.push_back(holds ? 1.0 : 0.0); }
};

// Takes facts from numbers in the same order.
struct FactsFromNumbers
{
  std::vector<double>::const_iterator next;

  void Least(double& number) { number = *this->next++; }
  void Least(Integration& choice) { choice = Integration(int(*this->next++)); }
  void Greatest(double& number) { number = -*this->next++; }
  void IfAny(bool& holds) { holds = HoldsForAny(*this->next++); }
  void IfAll(bool& holds) { holds = *this->next++ > 0.0; }
};

}

std::vector<double> NumbersOf(const SearchFacts& facts)
{
  FactsToNumbers to;
  ForEachFact(facts, to);
  return to.numbers;
}

SearchFacts FactsOf(const std::vector<double>& numbers)
{
  SearchFacts facts;
  FactsFromNumbers from{ numbers.begin() };
  ForEachFact(facts, from);
  facts.range.finest = std::min(facts.range.finest, facts.range.coarsest);
  return facts;
}

}
