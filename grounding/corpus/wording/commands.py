"""Productions of commands: picking, placing, clearing."""

TEXT = """
[pick.verb]
take 5 : take
grab 5 : grab
lift 2 : lift
get 2.5 : get
select 2 : select
choose 1.5 : choose
find 1 : find
touch 0.8 : touch
remove 0.5 : remove
pick 3 : pick
fetch 0.5 : fetch|grasp|raise|collect|hold|identify|locate
bring 0.3 @viewer : bring (NP me)
give 0.3 @viewer : give/VB (NP me)

[pick.vp]
up 12 : (VP pick (PRT up/RP) <block>)
up.last 1.2 : (VP pick <block.brief> (PRT up/RP))
verb 12 : (VP <pick.verb> <block>)
several 1.5 : (VP pick (PRT up/RP) <blocks>)
several.verb 1.5 : (VP <pick.verb> <blocks>)
set 0.8 @arrangement : (VP pick (PRT up/RP) <set>)
set.verb 0.8 @arrangement : (VP <pick.verb> <set>)
lift.up 0.4 : (VP lift|grab (PRT up/RP) <block>)
of.those 1.5 @arrangement : (VP (PP of <plural.front>) pick (PRT up/RP) <block.choice>)
of.those.verb 1 @arrangement : (VP (PP of|from|in <plural.front>) <pick.verb> <block.choice>)
place.first 1.2 : (VP <location> pick (PRT up/RP) <block.brief>)
place.first.verb 0.8 : (VP <location> <pick.verb> <block.brief>)
relation.first 0.5 @deep : (VP <relation> pick|find|grab|take <block.brief>)
view.first 0.7 @viewer : (VP <view.pp> pick (PRT up/RP) <block>)
looking.first 0.6 : (VP (PP looking (PP at <looked.at>)) pick|find (PRT up/RP) <block>)
view.last 0.4 @viewer : (VP pick (PRT up/RP) <block.brief> <view.pp>)
pick.out 0.2 : (VP pick (PRT out/RP) <block>)
then.one 0.3 @loose : (VP go/VB to/IN <block>)
person.first 0.8 @viewer : (VP (PP to|on (NP (NP the left|right/NN) (PP of <person>))) pick|grab|take <block.brief>)

[plural.front]
blocks 6 @arrangement : (NP <bases>)
blocks.where 5 @arrangement : (NP (NP <bases>) <location>)
set 3 @arrangement : <set.simple>
that 0.8 @arrangement : (NP (NP <bases>) <that.are>)

[block.choice]
ranked 8 : (NP the <rank> <noun>)
rank.alone 3 : (NP the <rank>)
where 3 : (NP (NP the <noun>) <where>)
nth 1 : (NP (NP the <ordinal> <noun>) <from.side>)
that 1 : (NP (NP the <noun>) <that>)

[put.verb]
put 8 : put
place 8 : place
move 14 : move
set 3 : set
stack 2 @stacked : stack
slide 2 : slide
shift 1.5 : shift
push 1 : push
bring 0.7 : bring
lay 0.4 : lay|drop|position|reposition|pull

[place.vp]
plain 22 : (VP <put.verb> <block> <destination>)
place.block.stack 2 @stacked : (VP stack|place|put|move <block> <onto>)
take.and 8 @history : (VP (VP <taking> <block>) and (VP <put.verb> <pronoun> <destination>))
take.then 1 @history : (VP (VP <taking> <block>) and (VP then <put.verb> <pronoun> <destination>))
move.and 1 @history : (VP (VP move|slide|shift <block> <path>) and (VP <put.verb> <pronoun> <destination>))
pronoun 4 @history : (VP <put.verb> <pronoun> <destination>)
pronoun.down 0.4 @history : (VP set|put <pronoun> (PRT down/RP) <destination>)
several 2 : (VP <put.verb> <blocks> <destination>)
set.moved 1 @arrangement : (VP <put.verb> <set> <destination>)
them 0.8 @history : (VP <put.verb> <pronouns> <destination>)
so.that 1.5 : (VP <put.verb> <block> <destination> <result>)
so.that.only 1 : (VP move|place|put|slide <block> <result>)
so.it 0.7 @history : (VP move|place|put|slide <pronoun> <result>)
until 0.7 : (VP move|slide|push|shift <block> <path> <until>)
two.steps 1.5 @distance : (VP <put.verb> <block.brief> (PP <path> then|and <path>))
place.then.path 0.7 @distance : (VP <put.verb> <block.brief> (PP <destination.pp> then|and <path>))
back 0.6 @history : (VP put|move|set|bring|place <pronoun> (PRT back/RP))
back.where 0.5 @history : (VP put|move|set|bring|place <pronoun> (PRT back/RP) <destination>)

of.those 1 @arrangement : (VP (PP of|in|from <plural.front>) move|take|put <block.choice> <destination>)
add 0.5 : (VP add/VB <block> <destination>)
swap 0.2 : (VP use/VB <block> (S (VP to/TO (VP make|form <set.new>))))
away 0.3 : (VP move|push|take <block> (PRT away/RP))
create 0.5 @arrangement : (VP make|form|create/VB <set.new> (PP with|from|by <block.brief>))
from.to 1.2 : (VP move|take|shift <block.brief> (PP from <reference>) <destination.pp>)

[taking]
take 8 : take
grab 1.5 : grab
get 1 : get
find 0.7 : find|locate
pick.up 3 : pick (PRT up/RP)
lift 0.6 : lift

[set.new]
row 3 @arrangement : (NP (NP a row|line|column|stack|tower/NN) (PP of (NP <number>)))
counted 2 @arrangement : (NP a <counted> row|line|tower|stack|diagonal/NN)
plain 2 @arrangement : (NP a new row|line|tower|stack|diagonal/NN|square)
shape 1 @arrangement : (NP a triangle|square|cross|shape|corner/NN)
second 0.7 @arrangement @stacked : (NP a second|third|new tower|stack/NN)
story 0.5 @arrangement @stacked : (NP a two|three|four/CD story tower|stack/NN)

[clear.vp]
blocks 8 : (VP clear|remove <blocks>)
set 4 @arrangement : (VP clear|remove <set>)
away 2 : (VP clear (PRT away/RP) <blocks>)
away.last 1 : (VP clear|take|move <blocks> (PRT away/RP))
everything 2 : (VP clear|remove (NP (NP everything) <where>))
off 1 : (VP clear|remove|take <blocks> (PP from|off <table>))
one 2 : (VP clear|remove <block>)
stack 1.5 @stacked : (VP clear|remove <stack>)
out.of.way 0.5 : (VP move|get|clear <blocks> (PRT out/RP) (PP of (NP the way)))
place 1 : (VP clear|empty/VB (NP (NP the left|right|front|back/JJ side) (PP of <table>)))
them 0.4 @history : (VP clear|remove <pronouns>)
"""
