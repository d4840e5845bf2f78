"""Productions of noun phrases for one block or several."""

TEXT = """
[noun]
block 12 : block
cube 4 : cube
box 4 : box
brick 2 : brick
one 3 : one/NN
piece 1 : piece
object 0.3 : object
square 0.3 @loose : square

[nouns]
blocks 12 : blocks
cubes 4 : cubes
boxes 4 : boxes
bricks 2 : bricks
ones 1 : ones
pieces 1 : pieces
objects 0.3 : objects

[color]
common 12 @color : red|blue|green|yellow|orange
others 1 @color : purple|white|black|gray|brown|pink

[det]
the 30 : the
that 1 : that/DT
this 0.3 : this

[ordinal]
words 10 : second|third|fourth|first|fifth
digits 2 : 2nd|3rd|1st|4th|5th
high 1.5 : sixth|seventh|eighth|ninth
last 1 : last
next 0.4 : next
to.last 0.6 : second|third to last

[near]
superlative 10 : closest|nearest
comparative 1 : closer|nearer

[farthest]
superlative 8 : farthest|furthest
away 2 : farthest|furthest away
comparative 0.7 : farther|further
most 0.3 @loose : furthest|farthest most

[edgemost]
sides 6 : leftmost|rightmost
ends 3 : topmost|bottommost|uppermost
compass 2 @compass : northernmost|southernmost|westernmost|easternmost
heights 4 : highest|lowest
depth 0.7 : frontmost|backmost

[place.word]
side 6 : left|right
height 5 : top|bottom|upper|lower
depth 2.5 : front|back|rear
middle 4 : middle|center|central
pair 5 : <high> left|right
depth.pair 1 : front|back|near|far/JJ left|right
far 2 : far left|right|top|bottom
nearness 1.2 : near|far/JJ
middle.pair 0.8 : middle|center left|right
pair.middle 0.6 : left|right|top|bottom|upper|lower middle|center
compass 2 @compass : north|south|east|west|northeast|northwest|southeast|southwest
compass.adjective 1 @compass : northern|southern|eastern|western|northeastern|northwestern|southeastern|southwestern
bare.most 0.4 @loose : very top|bottom
most 0.3 @loose : most/RBS left|right|northern/JJ

[high]
word 1 : top|bottom|upper|lower

[rank]
near 7 : <near>
farthest 6 : <farthest>
edgemost 8 : <edgemost>
place.word 14 : <place.word>
ordinal 4 : <ordinal>
ordinal.near 1.5 : second|third|fourth|2nd closest|nearest
ordinal.far 1.5 : second|third|fourth|2nd farthest|furthest
ordinal.edgemost 1.5 : second|third|fourth|2nd <edgemost>
near.edgemost 0.6 : closest|nearest leftmost|rightmost
place.lone 0.7 : <lone> <place.word>
lone.place 0.7 : <place.word> <lone>
other 1.2 : other
other.place 0.4 : other <place.word>
same 0.4 @history : same

[lone]
only 4 : only
others 6 : lone|single|solitary|isolated|loose
standing 0.5 : separate|standalone
free 0.7 : free-standing|freestanding|solo|stray

[base]
bare 7 : <det> <noun>
colored 9 @color : <det> <color> <noun>
ranked 9 : <det> <rank> <noun>
ranked.colored 6 @color : <det> <rank> <color> <noun>
lone 3 : <det> <lone> <color>?.5 <noun>
indefinite 1 : a <color>?.5 <noun>
color.alone 0.5 @color @loose : the <color>
rank.alone 0.5 @loose : the <rank>
own 0.3 @history : its <place.word> block

[number]
words 10 : two|three|four|five
digits 3 : 2|3|4|5
high 1 : six|seven|eight
hyphen.none 0.1 : nine|ten

[block]
base 10 : (NP <base>)
where 10 : (NP (NP <base>) <where>)
where.twice 3 : (NP (NP (NP <base>) <where>) <where>)
that 6 : (NP (NP <base>) <that>)
where.that 2 : (NP (NP (NP <base>) <where>) <that>)
that.where 0.8 : (NP (NP (NP <base>) <that>) <where>)
that.that 0.6 : (NP (NP (NP <base>) <that>) and <that>)
near.person 2.5 @viewer : (NP (NP <det> <near> <color>?.7 <noun>) (PP to <person>))
near.reference 1 @deep : (NP (NP the <near> <color>?.7 <noun>) (PP to <reference>))
far.person 2 @viewer : (NP (NP the <farthest> <color>?.7 <noun>) (PP from <person>))
furthest.side 1.2 : (NP (NP the furthest|farthest <color>?.7 <noun>) (PP to|on <side.np>))
nth.from 4 : (NP (NP <det> <ordinal> <color>?.5 <noun>) <from.side>)
nth.from.in 1.5 @arrangement : (NP (NP (NP <det> <ordinal> <color>?.4 <noun>) <from.side>) <in.set>)
nth.in.from 1.5 @arrangement : (NP (NP (NP <det> <ordinal> <color>?.4 <noun>) <in.set>) <from.side>)
nth.down 0.7 : (NP (NP the <ordinal> <noun>) (PP down|up))
ranked.in 6 @arrangement : (NP (NP <det> <rank> <color>?.4 <noun>) <in.set>)
placed.in 3 @arrangement : (NP (NP <base>) <in.set>)
near.of 1.5 @arrangement @deep : (NP (NP (NP the closest|nearest <color>?.6 <noun>) (PP to <reference>)) <in.set>)
one.of 0.7 @arrangement : (NP (NP one/CD) (PP of (NP the <number> <color>?.5 <nouns>)))
one.of.placed 0.4 @arrangement : (NP (NP one/CD) (PP of <blocks>))
other.than 0.5 @deep : (NP (NP <base>) (PP other than <reference>))
number.from 0.5 : (NP (NP <noun> number/NN one|two|three/CD) <from.side>)
top.of.stack 3 @stacked : (NP (NP the top|topmost|uppermost|highest|bottom|middle <color>?.4 <noun>) <in.stack>)
stack.top 1 @stacked : (NP (NP the top/NN) (PP of <stack>))
tower.its.top 0.3 @stacked @history : (NP its top block|box|cube|piece)

[block.brief]
base 10 : (NP <base>)
where 6 : (NP (NP <base>) <where>)
that 1 : (NP (NP <base>) <that>)
nth.from 1 : (NP (NP the <ordinal> <color>?.5 <noun>) <from.side>)
ranked.in 2 @arrangement : (NP (NP the <rank> <noun>) <in.set>)
top.of.stack 2 @stacked : (NP (NP the top <noun>) <in.stack>)
stack.top 0.7 @stacked : (NP (NP the top/NN) (PP of <stack>))

[pronoun]
it 10 @history : (NP it)
that.one 1 @history : (NP that/DT one/NN)
this.one 0.3 @history : (NP this one/NN)
that 0.3 @history : (NP that/DT)
that.block 2 @history : (NP that|this/DT block|box|cube)
one.moved 0.7 @history : (NP (NP the <noun>) (SBAR (S (NP you) (VP <just.moved>))))
other.one 0.7 @history : (NP the other one/NN)
same.block 0.7 @history : (NP the|this/DT same block|box|cube|one/NN)
plain 1 @history : (NP the block|box|cube)

[just.moved]
just 4 @history : just/RB moved|placed|put/VBD
last 1 @history : moved|placed|picked/VBD last/RB
perfect 0.4 @history : have/VBP just moved|placed/VBN
before 0.5 @history : moved|placed/VBD before/RB

[pronouns]
them 8 @history : (NP them)
both 1 @history : (NP both)
these 0.5 @history : (NP these|those <nouns>)

[bases]
counted 8 : the <number> <color>?.5 <nouns>
counted.ranked 4 : the <number> <rank.plural> <color>?.4 <nouns>
ranked.counted 2 : the <rank.plural> <number> <nouns>
all 3 : all/PDT the <color>?.5 <nouns>
all.bare 1 : all/DT <color>?.5 <nouns>
all.counted 0.7 : all/DT <number> <nouns>
both 1.5 : both/DT <color>?.5 <nouns>
both.the 0.7 : both/PDT the <color>?.5 <nouns>
plain 3 : the <color>?.5 <nouns>
other 1 : the other <number>?.5 <color>?.3 <nouns>
those 0.7 : those <number>?.4 <color>?.4 <nouns>
colors 0.7 @color : the <color> and <color> <nouns>
counted.alone 1 : the <number>
only 0.5 : the only <number> <color>?.6 <nouns>
touching 0.5 : the <number> touching <nouns>
every 0.5 : every|each <color>?.5 block|cube

[rank.plural]
near 4 : closest|nearest
far 3 : farthest|furthest
edgemost 4 : leftmost|rightmost|topmost|bottommost|highest|lowest
place.word 4 : left|right|top|bottom|middle|upper|lower
first 1 : first|last
isolated 0.6 : isolated|loose|adjacent|lone

[blocks]
base 8 : (NP <bases>)
where 8 : (NP (NP <bases>) <where>)
that 2 : (NP (NP <bases>) <that.are>)
two 0.5 @deep : (NP <block.brief> and <block.brief>)
near.person 0.7 @viewer : (NP (NP the <number> closest|nearest <color>?.5 <nouns>) (PP to <person>))
everything 0.4 : (NP (NP everything) <where>)
all.of 0.6 @deep : (NP (NP all/DT) (PP of <blocks>))
"""
