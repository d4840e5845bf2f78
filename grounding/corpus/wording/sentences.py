"""Productions of whole texts: politeness, framing, several sentences."""

TEXT = """
[adverb]
please 6 : please
then 2 @history : then
now 2 @history : now/RB
next 0.6 @history : next/RB
just 0.5 : just/RB
so 0.2 @loose : so/RB
hesitation 0.6 @loose : um|uh|well|okay/UH

[modal]
can 2 : can
could 3 : could
would 1 : would
will 0.3 : will

[pick]
plain 22 : <pick.vp>
polite 4 : (VP please <pick.vp>)
modal 2.5 : (S <modal> (NP you) <pick.vp>)
wish 3 @viewer : <wish.pick>
adverb 2 : (VP <adverb> <pick.vp>)
last.please 1.5 : (VP <pick.vp> please)
look.and 1 : (VP (VP look (PP at <looked.at>)) and <pick.vp>)
locate.and 0.7 : (VP locate|find/VB and pick (PRT up/RP) <block>)
there.is.take 4 @several : <there.is> <pick.follow>
look.take 1.5 @several : <look.vp> <pick.follow>
take.it.is 1.2 @several @history : <pick.vp> <target.is>
block.is.take 1 @several @history : <target.is> (VP pick <pronoun> (PRT up/RP))
find.pick 1 @several @history : (VP find|locate|identify <block>) (VP pick <pronoun> (PRT up/RP))
twice 0.7 @several : <pick.vp> <block.restated>
hand.first 0.4 @several @viewer : (VP raise|lift|use/VB (NP your left|right/JJ hand|arm)) <pick.vp>
reach 0.4 : (VP (VP reach/VB <reaching>) and <pick.vp>)
separate.it 0.3 @several @history : <look.vp> (S (NP it) (VP <is> <where>))
narrow 0.2 @several @viewer : (S (NP i) (VP will (VP tell|guide/VB (NP you)))) <pick.vp>
framed.wish 0.8 @viewer : (S <frame> <wish.framed>)

[look.vp]
at 3 @several : (VP look (PP at <looked.at>))
for 1.5 @several : (VP look (PP for/IN (NP a <color>?.7 <noun>)))
find 2 @several : (VP find|locate|identify <looked.at>)
to 1 @several : (VP look <location>)

[looked.at]
blocks 5 : <blocks>
table 2 : <table>
set 2 @arrangement : <set>
block 3 : <block.brief>

[block.restated]
one 1 @several : (NP (NP the one/NN) <where>)
that 0.6 @several : (NP (NP the one/NN) <that>)

[pick.follow]
up 4 @several : (VP pick (PRT up/RP) <block.choice>)
verb 4 @several : (VP <pick.verb> <block.choice>)
it.up 2 @several @history : (VP pick <pronoun> (PRT up/RP))
of.those 0.7 @several @history : (VP pick (PRT up/RP) (NP (NP the <rank> one/NN) (PP of (NP those|these|them))))
want 0.5 @several @viewer : (S (NP you|i) (VP want/VBP <block.choice>))

[place]
plain 20 : <place.vp>
polite 2.5 : (VP please <place.vp>)
modal 1 : (S <modal> (NP you) <place.vp>)
wish 1 @viewer : <wish.place>
adverb 1.5 : (VP <adverb> <place.vp>)
last.please 1 : (VP <place.vp> please)
take.then.put 4 @several @history : (VP <taking> <block>) <put.follow>
there.is.move 4 @several @history : <there.is> <put.follow>
there.is.take 3 @several @history : <there.is> <take.follow>
find.move 1 @several @history : (VP find|locate <block>) <put.follow>
look.move 0.6 @several @history : <look.vp> <take.follow>
move.then.path 1 @several @history @distance : <place.vp> (VP <adverb.then>?.6 move|slide|shift <pronoun> <path>)

[adverb.then]
then 3 @history : then
now 1 @history : now/RB

[put.follow]
put 6 @several @history : (VP <adverb.then>?.1 <put.verb> <pronoun> <destination>)
result 1 @several @history : (VP <put.verb> <pronoun> <destination> <result>)
so 0.7 @several @history : (VP move|place|put <pronoun> <result>)
stack 0.7 @several @history @stacked : (VP stack|place|put <pronoun> <onto>)
down 0.4 @several @history : (VP set|put <pronoun> (PRT down/RP) <destination>)

[take.follow]
move 5 @several : (VP move|put|place|slide <block.choice> <destination>)
take.and 4 @several @history : (VP (VP <taking> <block.choice>) and (VP <put.verb> <pronoun> <destination>))

[clear]
plain 8 : <clear.vp>
polite 2 : (VP please <clear.vp>)
modal 1.5 : (S <modal> (NP you) <clear.vp>)
wish 1 @viewer : (S (NP i) (VP want/VBP (S (NP you) (VP to/TO <clear.vp>))))
last.please 0.6 : (VP <clear.vp> please)

[statement]
plain 14 : <statement.core>
there.is.goes 2 @several @history : <there.is> (S <choice.np.any> (VP <moves> <destination>))
and.then 1 @history : (S <statement.core> and (VP then/RB <moves> <path>))
twice 1 @several @history : <statement.core> (S <pronoun> (VP <adverb.then>?.2 <moves> <destination>))
target 4 : <target.is>

[choice.np.any]
choice 2 @several : <block.choice>
it 2 @several @history : <pronoun>

[description]
block 10 : <block>
blocks 2 : <blocks>
set 1 @arrangement : <set>
one.and.then 0.6 @several : <block.brief> <block.restated>
there.is 1.5 : <there.is>

[reaching]
over 2 : (PP over|across|past|to <blocks>)
table 1 : (PP across|over <table>)
person 1 @viewer : (PP out (PP in (NP (NP front/NN) (PP of (NP you)))))

[frame]
view 2 @viewer : <view.pp>
looking 1.5 @viewer : (PP looking (PP at <looked.at>))
location 1 @viewer : <location>

[wish.framed]
would 2 @viewer : (NP i) (VP would <pick.vp>)
are.to 1 @viewer : (NP you) (VP are (S (VP to/TO <pick.vp>)))
want.to 1 @viewer : (NP you) (VP want/VBP (S (VP to/TO <pick.vp>)))
can.see 1 @viewer : (NP you) (VP can (VP see/VB (NP (NP a|the <color>?.6 <noun>) <where>)))
should 1 @viewer : (NP you) (VP should|will|can <pick.vp>)
"""
