"""Productions of arrangements: rows, columns, groups, rings, towers."""

TEXT = """
[set.noun]
row 7 @arrangement : row
column 4 @arrangement : column
line 4 @arrangement : line
diagonal 1.5 @arrangement : diagonal/NN
group 3 @arrangement : group/NN
cluster 3 @arrangement : cluster
pair 1.5 @arrangement : pair
ring 1.5 @arrangement : circle|ring
others 1 @arrangement : set|bunch|grouping|formation|arrangement|clump|string|structure|trio/NN
stack 3 @arrangement @stacked : stack|tower|pile/NN

[stack.noun]
tower 10 @stacked : tower
stack 10 @stacked : stack/NN
pile 1 @stacked : pile

[set.rank]
place.word 10 @arrangement : <place.word>
edgemost 3 @arrangement : leftmost|rightmost|topmost|bottommost
near 2 @arrangement : closest|nearest|farthest|furthest
ordinal 3 @arrangement : <ordinal>
size 2 @arrangement : long|short|longest|shortest|longer|shorter
orientation 1.5 @arrangement : vertical|horizontal|diagonal
other 0.5 @arrangement : other
only 0.4 @arrangement : only
color 1 @arrangement @color : <color>

[stack.rank]
place.word 8 @stacked : <place.word>
size 4 @stacked : tall|taller|tallest|short|shorter|shortest|highest
near 2 @stacked : closest|nearest|farthest|furthest
edgemost 2 @stacked : leftmost|rightmost
other 0.7 @stacked : other|only
multiple 1 @stacked : double|triple
ordinal 0.7 @stacked : first|second|third
color 0.5 @stacked @color : <color>

[counted]
block 5 : <number> block
unit 1.5 : <number> story|high/NN
piece 1 : <number> box|cube|brick|piece

[set.simple]
bare 6 @arrangement : (NP <det> <set.noun>)
ranked 6 @arrangement : (NP <det> <set.rank> <set.noun>)
counted 3 @arrangement : (NP <det> <counted> <set.noun>)
ranked.counted 0.7 @arrangement : (NP the <set.rank> <counted> <set.noun>)
of.count 4 @arrangement : (NP (NP <det> <set.rank>?.3 <set.noun>) (PP of (NP <number>)))
of.blocks 4 @arrangement : (NP (NP <det> <set.rank>?.3 <set.noun>) (PP of (NP <number>?.8 <color>?.4 <nouns>)))
indefinite 0.6 @arrangement : (NP (NP a <set.noun>) (PP of (NP <number> <color>?.4 <nouns>)))
blocks 3 @arrangement : (NP <bases>)
plural 1 @arrangement : (NP the <number>?.5 rows|columns|lines|groups|clusters|towers|stacks)

[set]
simple 10 @arrangement : <set.simple>
where 3 @arrangement : (NP <set.simple> <where>)
that 1 @arrangement : (NP <set.simple> <that.set>)
made.of 0.5 @arrangement : (NP <set.simple> (PP formed|made by|of (NP the <number> <nouns>)))
blocks.in.line 0.7 @arrangement : (NP (NP the <number> <color>?.4 <nouns>) <in.formation>)
blocks.that 0.6 @arrangement : (NP (NP the <number> <color>?.4 <nouns>) <that.are>)

[in.formation]
row 4 @arrangement : (PP in (NP a row|line|column|circle|cluster|group))
diagonal 1 @arrangement : (PP in (NP a diagonal vertical|horizontal|diagonal line|row))
together 0.5 @arrangement : (PP forming|making (NP a row|line|diagonal/NN|column|circle))

[stack]
bare 8 @stacked : (NP <det> <stack.noun>)
ranked 7 @stacked : (NP <det> <stack.rank> <stack.noun>)
counted 3 @stacked : (NP <det> <counted> <stack.noun>)
of.count 3 @stacked : (NP (NP <det> <stack.rank>?.2 <stack.noun>) (PP of (NP <number>)))
of.blocks 3 @stacked : (NP (NP <det> <stack.rank>?.2 <stack.noun>) (PP of (NP <number>?.6 <nouns>)))
where 4 @stacked : (NP (NP <det> <stack.noun>) <where>)
of.blocks.where 1 @stacked : (NP (NP (NP the <stack.noun>) (PP of (NP <number>?.6 <nouns>))) <where>)
stacked.blocks 0.6 @stacked : (NP the <number>?.5 stacked <nouns>)

[in.set]
in 8 @arrangement : (PP in <set>)
of 7 @arrangement : (PP of <set>)
from 0.7 @arrangement : (PP from|on <set>)
within 0.5 @arrangement : (PP within|inside|among <set>)
out.of 0.2 @arrangement : (PP out/RP of <set>)
that.are 0.7 @arrangement : (PP of (NP (NP the <number>) <that.are>))
of.three 1.5 @arrangement : (PP of (NP the <number> <nouns>?.5))

[in.stack]
of 8 @stacked : (PP of <stack>)
in 5 @stacked : (PP in|on <stack>)
from 3 @stacked : (PP from|off <stack>)
off.of 0.6 @stacked : (PP off of <stack>)
"""
