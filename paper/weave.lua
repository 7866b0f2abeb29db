-- The weaver: a reader of pandoc that puts what the build found in place of the directives in paper/*.md, for LaTeX and for
-- the web. What it puts there is Markdown. What cannot be found is told with file and line, and nothing is woven.
--     pandoc -f paper/weave.lua -t latex CHAPTER.md ...
-- From the environment: CT_PROGRAM, CT_DATA, CT_BUILD; for the web CT_PAGE, the page's name.
-- A line by itself:
--   <<equation ID [NAME ...]>>   the formula from the sheet as parsed, under its number; of several those named
--   <<printed ID [NAME ...]>>    what the paper has instead, and why it cannot be
--   <<function ID>>              the function of ref/ that carries the equation's number;  <<helper NAME>>  another one
--   <<step ID>>                  a derivation step, its algebra, where it holds, and what is dropped
--   <<verdict ID>>               a verdict;  <<findings VERDICT>>  a table of those that have it, and why
--   <<run ARGUMENT ...>>         a command of the program, and what it prints
--   <<rows KEY ...>> LINE        the line for each key, in place of @; @1 and @2 are the parts of a key A,B
--   <<symbols>>, <<index>>       rows of tables: the quantities of the sheet, the index of equations
--   <<places>>, <<verdicts>>     for the web: each equation with all that belongs to it; all verdicts
--   ![CAPTION](plot:NAME)        a plot of data/;  ![CAPTION](graph:CHAPTER)  what a chapter's steps lead from and to
-- Within a line, the first two between dollars:
--   <<number FILE ROW COLUMN DIGITS[*SCALE]>>   from data/FILE or build/FILE, the row by its first columns: A,B
--   <<value NAME DIGITS[*SCALE] ARGUMENT ...>>  what a command of the program finds
--   <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
--   <<count WHAT>>                    vectors, inputs, misprints, verdicts, or one kind of verdict
--   [(7)](#eq:7), [section](#ID), [Figure](#fig:NAME), [](#ref:NAME)            have to lead somewhere

local web, data, build = os.getenv 'CT_PAGE', os.getenv 'CT_DATA', os.getenv 'CT_BUILD'
local where, stops = '', 0  -- file and line of what is being woven; how many of them could not be

local function stop(text, ...)
  io.stderr:write(where, ': ', text:format(...), '\n')
  stops = stops + 1
  error(stop)
end
local function the(kind, list, name) return list[name] or stop("unknown %s '%s'", kind, name) end

---- reading ----

local function read(path)
  local file = io.open(path)
  return file and file:read 'a'
end
local function made(path) return read(build .. '/' .. path) or error('no ' .. build .. '/' .. path .. ': run make check') end

local function output_of(command)
  local pipe = io.popen(command)
  local text = pipe:read 'a'
  return pipe:close() and text
end
local function run(words) return output_of('"$CT_PROGRAM" ' .. words) or stop('coulomb-tether %s failed', words) end

local P, R, S, C, Cs, Ct = lpeg.P, lpeg.R, lpeg.S, lpeg.C, lpeg.Cs, lpeg.Ct

-- JSON is Lua but for brackets and colons. Entries can be found by their id.
local quoted = '"' * (P '\\' * 1 + (1 - P '"'))^0 * '"'
local as_lua = Cs((C(quoted) * ':' / '[%1]=' + quoted + P '[' / '{' + P ']' / '}' + 1)^0)
local function by_id(list)
  list = pandoc.List(list)
  for _, entry in ipairs(list) do list[entry.id] = entry end
  return list
end
local function json(path) return load('return ' .. as_lua:match(made(path)))() end

-- The rows of a CSV file by its columns' names; no field of ours has a quotation mark or a line break in it.
local field = '"' * C((1 - P '"')^0) * '"' + C((1 - S ',\n')^0)
local records = Ct((Ct(field * (',' * field)^0) * '\n')^0)
local function rows_of(text)
  local rows = records:match(text)
  local heads = table.remove(rows, 1)
  for _, row in ipairs(rows) do
    for i, head in ipairs(heads) do row[head] = row[i] end
  end
  return rows
end

local steps, verdicts = by_id(json 'derivations.json'.derivations.steps), by_id(json 'claims.json'.claims)
local gate, inputs = by_id(rows_of(made 'gate.csv')), json 'errors.json'.errors[1].inputs

local counts = {verdicts = #verdicts, inputs = inputs, vectors = 0, misprints = 0, refuted = 0}
for _, row in ipairs(gate) do counts.vectors = counts.vectors + (tonumber(row.vectors) or 0) end
for _, v in ipairs(verdicts) do
  counts[v.verdict] = (counts[v.verdict] or 0) + 1
  if v.verdict == 'holds as corrected' and v.kind == 'equation' then counts.misprints = counts.misprints + 1 end
end

-- {2a, 2b, 2c} as the reader sees it: 2a to 2c.
local function span_of(list)
  if #list < 2 then return list[1] end
  return list[1] .. (#list == 2 and ', ' or '–') .. list[#list]
end

-- Of the sections that have a number one is named for it alone; (6) stands where (6a) does.
local sections, section_of, symbol, labels = by_id(json 'equations.json'), {}, {}, {}
for _, s in ipairs(sections) do
  s.numbers, s.names = pandoc.List(s.equations), {}
  for _, quantities in ipairs {s.inputs, s.outputs} do
    for _, quantity in ipairs(quantities) do symbol[quantity.name] = quantity.tex end
  end
  for _, number in ipairs(s.id:match '^eq%d+$' and s.numbers or {}) do
    for _, name in ipairs {number, number:match '^(%d+)a$'} do
      section_of[name], labels['eq:' .. name], s.names[#s.names + 1] = s.id, {text = '', page = 'equations.html'}, name
    end
  end
end
for name in ('pi lambda mu phi kappa epsilon rho omega cos sin tan'):gmatch '%a+' do symbol[name] = '\\' .. name end

-- (1) is no formula of the sheet: vectors are none of its quantities.
sections.eq01.display = {{kind = 'relation', equation = '1', defines = '', tex = '\\boldsymbol\\rho = (x,\\; y,\\; z)'}}

-- Chapters, figures of ours and references are numbered as they come; those without a number are the last chapters.
local pages, page_of_step, letters, cited = {}, {}, 0, 0
for path in output_of 'ls paper/[0-9]*.md':gmatch '%S+' do
  local file, text = path:match '([^/]*)%.md$' .. '.html', read(path)
  local function label(id, name) labels[id] = {text = name, page = file} end
  local title, id, unnumbered = text:match '^# (.-) {#(%S+)( ?[^\n]*)}'
  label(id, unnumbered == '' and tostring(#pages + 1) or '')
  pages[#pages + 1] = {file = file, title = title, number = labels[id].text}
  for name in text:gmatch '%]%(%a+:([%w-]+)%)' do
    local ours = not name:match '^%d%a?$'
    letters = letters + (ours and 1 or 0)
    label('fig:' .. name, ours and string.char(64 + letters) or name)
  end
  for reference in text:gmatch '{#(ref:%w+)}' do
    cited = cited + 1
    label(reference, '[' .. cited .. ']')
  end
  for step in text:gmatch '\n<<step ([%w_]+)>>' do page_of_step[step] = file end
end

-- What is referred to has its number after it.
local function link(text, id)
  local label = the('reference', labels, id)
  text = text .. (text ~= '' and label.text ~= '' and '\u{a0}' or '') .. label.text
  return web and ('[%s](%s#%s)'):format(text, label.page, id) or ('\\hyperref[%s]{%s}'):format(id, text)
end
local function equation_link(number) return link('(' .. number .. ')', 'eq:' .. number) end

---- Markdown ----

local function formula(tex) return '$' .. tex:gsub('%s+$', '') .. '$' end

local function scientific(digits, exponent)
  return digits .. (tonumber(exponent) == 0 and '' or ('\\times 10^{%d}'):format(exponent))
end
-- So many significant digits: "3", or "3*SCALE".
local function decimal(value, form)
  local digits, scale = form:match '^(%d+)%*?(.*)$'
  value = value * (tonumber(scale) or 1)
  local text = math.abs(value) < 1e-3 and ('%%.%de'):format(digits - 1):format(value) or ('%%#.%dg'):format(digits):format(value)
  return (text:gsub('%.$', ''):gsub('^(.*)e(.*)$', scientific))
end

-- A text of the sheet, of a step or of the program: its signs and powers that are numbers become mathematics, and so do symbols.
-- Where it has units these have more than a letter; in a text without, letters with a digit or an index are symbols as well. What
-- the program typeset has all of them between dollars.
local digit, letter, sign = R '09', R('az', 'AZ'), P(false)
local real = digit^1 * ('.' * digit^1)^-1
for text, name in ('<= le >= ge << ll -> to +- pm -+ mp * cdot'):gmatch '(%S+) (%S+)' do
  -- with the digits after it: a dollar before a digit is none
  sign = sign + P(text) * C(real^-1) / function(digits) return formula('\\' .. name .. ' ' .. digits) end
end
sign = sign + (lpeg.B(S ' (') + -lpeg.B(1)) * (P '-' * (real + #(letter + ' '))) / formula
local number = C(P '-'^-1 * real) * 'e' * C(S '+-'^-1 * digit^1) / function(...) return formula(scientific(...)) end
               + P '^' * C(P '-'^-1 * digit^1) / '$^{%1}$'
local dollars = '$' * C((1 - P '$')^0) * '$' / formula + P 'uC' / 'µC'
local function marked(shortest)
  local function named(text)
    if symbol[text] and text ~= 'stable' and #text >= shortest then return formula(symbol[text]) end
    local stem, index = text:match '^(%a)(%d?)$'
    if not stem then stem, index = text:match '^(%a)_(%w+)$' end
    if stem and shortest == 1 then return formula(stem .. (index == '' and '' or '_{\\mathrm{' .. index .. '}}')) end
    return text:gsub('_', '\\_')
  end
  local article = P 'a' * #(P ' ' * letter)
  local name = letter * (letter + digit + '_' + P "'" * #letter)^0
  local all = Cs((dollars + number + digit * letter / '%0' + article + C(name) / named + sign + S '`*_{}[]<>#|^@"' / '\\%0' + 1)^0)
  return function(text) return (all:match(text):gsub('%$%$', ' ')) end
end
local prose, with_units, typeset = marked(1), marked(2), marked(math.huge)

-- What one of the two formats has alone; the other leaves it out.
local function raw(text, format) return ('\n\n```{=%s}\n%s\n```\n\n'):format(format or 'latex', text) end
local function raw_inline(text) return '`' .. text .. '`{=latex}' end
-- Blocks of a class: what LaTeX calls an environment.
local function box(class, text, id) return ('\n\n::: {.%s%s}\n%s\n:::\n\n'):format(class, id and ' #' .. id or '', text) end
-- What a reader opens on demand.
local function details(summary, text)
  return raw('<details><summary>' .. summary .. '</summary>', 'html') .. text .. raw('</details>', 'html')
end

---- equations ----

local qualifier = {lin = 'small angles', inv = 'inverse', exact = 'exact', roots = 'roots', flow = 'flow', rk4 = 'Runge-Kutta'}
local function qualified(id) return qualifier[id:match '^eq%d+(.*)$' or id:match '^%a+%d?'] end

-- Rows that share a number, side by side where they are short, or as many in a line as it holds.
local aside = {let = '\\text{with}\\quad ', domain = '\\text{for}\\quad '}
local function group(kind, texts)
  local longest = math.max(table.unpack(pandoc.List(texts):map(string.len)))
  if #texts == 1 then return aside[kind] and aside[kind] .. texts[1]:gsub('&', '') or texts[1] end
  if longest < 32 and (kind == 'relation' or kind == 'domain') then
    return (aside[kind] or '') .. table.concat(texts, ',\\quad '):gsub('&', '')
  end
  local columns, out = #texts < 6 and 1 or math.max(138 // longest, 1), (aside[kind] or '') .. '\\begin{aligned}\n'
  for i, text in ipairs(texts) do
    out = out .. text .. (i == #texts and '\n\\end{aligned}' or i % columns ~= 0 and ' &\\qquad ' or ' \\\\\n')
  end
  return out
end

-- A display of a section's rows of these kinds, of several formulas those named. Each line has its number, but for what stands
-- aside. Lines that stand alone are aligned at their signs; groups have their own alignment and are centred.
local function equation(s, kinds, named, suffix, place)
  local only, has, taken, lines, aligned = {}, {}, {}, {}, not web
  for _, row in ipairs(s.display) do has[row.defines], taken[row.kind == 'relation' and row.equation] = true, true end
  for name in named:gmatch '%S+' do only[name] = the('output or named subexpression', has, name) end
  local free = span_of(s.numbers:filter(function(number) return not taken[number] end))
  for _, row in ipairs(s.display) do
    if kinds:find(row.kind, 1, true) and (not next(only) or row.defines == '' and row.kind ~= 'domain' or only[row.defines]) then
      local tag, last = not aside[row.kind] and (row.equation ~= '' and row.equation or free) or nil, lines[#lines] or {}
      if last.kind ~= row.kind or last.tag ~= tag then
        last = {kind = row.kind, tag = tag}
        lines[#lines + 1] = last
      end
      table.insert(last, row.tex)
    end
  end
  for _, line in ipairs(lines) do
    line.tex = group(line.kind, line)
    aligned = aligned and line.tex:match '^[^&]*&[^&]*$'
  end
  for i, line in ipairs(lines) do
    local tex = (aligned or line.tex:find('{aligned}', 1, true)) and line.tex or line.tex:gsub('&', '')
    local tag = line.tag and line.tag .. (suffix and ', ' .. suffix or '')
    lines[i] = web and box('equation', '$$' .. tex .. '$$' .. (tag and '[(' .. tag .. ')]{.number}' or ''))
               or tex .. (tag and '\\tag{' .. tag:gsub('–', '--') .. '}' or '\\notag')
  end
  local kind, all = aligned and 'align' or 'gather', table.concat(lines, web and '' or ' \\\\\n')
  return web and all or raw(('\\joined%s%%\n\\begin{%s}\n%s\n\\end{%s}'):format(place or '', kind, all, kind))
end

-- Where a section stands for the index, and its numbers for references.
local function targets(s)
  local out = web and '' or '\\place{' .. s.id .. '}'
  for _, name in ipairs(s.names) do out = out .. (web and '<a id="eq:%s"></a>' or '\\target{%s}'):format(name) end
  return out
end

-- Code of more lines would leave much of a page empty, and may be torn on paper.
local LONGEST_KEPT = 26
local function code(text, path)
  if web then return ('\n\n```{.%s}\n%s\n```\n\n'):format(path and 'c title="' .. path .. '"' or 'terminal', text) end
  local kind, title = path and 'code' or 'terminal', path and '{' .. path .. '}' or ''
  local listed = raw(('\\begin{%s}%s\n%s\\end{%s}'):format(kind, title, text, kind))
  return select(2, text:gsub('\n', '')) < LONGEST_KEPT and box('keep', listed) or listed
end
-- A function of ref/ by its name, as it stands there.
local function listing(name)
  for path in output_of 'ls ref/*.c':gmatch '%S+' do
    local text = ('\n' .. read(path)):match('\n(%a[^\n;{}]-%f[%w_]' .. name .. '%([^;{}]-%)\n{\n.-\n}\n)')
    if text then return code(text, path) end
  end
  stop("unknown function '%s'", name)
end

---- steps and verdicts ----

-- Equation numbers, sections or formulas of them, principles and properties, each once.
local function references(list)
  local out = {}
  for _, entry in ipairs(list) do
    local id, name = entry:match '^([^.]*)%.?(.*)$'
    local number = sections[id] and sections[id].numbers[1]:match '%d+' or section_of[entry] and entry
    local text = number and equation_link(number) or entry:gsub('_', '\\_')
    if number and name ~= '' then text = text .. '\u{a0}' .. formula(symbol[name] or name:gsub('_(.*)', '_{%1}')) end
    if not out[text] then out[text], out[#out + 1] = true, text end
  end
  return table.concat(out, ', ')
end

-- The algebra: each line equalities one after the other, and how one comes to them.
local function algebra(lines)
  local out = '\n\n'
  for _, line in ipairs(lines) do
    local how, chain = prose(line.how), table.concat(line.tex, ' = ')
    local rows = line.tex[1] .. ' &= ' .. table.concat(line.tex, ' \\\\ &= ', 2)
    out = out .. (web and how .. ': ' .. formula(chain)
      or raw_inline '\\derive{' .. how .. raw_inline(('}{%s}{%s}'):format(chain, rows))) .. '\n\n'
  end
  return out
end

local function name_of(v)
  return web and ('[%s](verdicts.html#%s){.id}'):format(v.id, v.id) or raw_inline('\\claim{' .. v.id .. '}')
end

-- On paper the evidence follows at once; on the web a reader opens it, and the reason stands before it.
local function verdict_of(v, id)
  local text = ('**%s:** %s (%s) %s\n\n'):format(v.verdict, typeset(v.claim_tex), typeset(v.where), name_of(v))
  local proof = typeset(v.evidence_tex) .. '.'
  text = text .. (web and typeset(v.why_tex or '') .. details('evidence, ' .. v.how, proof)
                  or box('evidence', '*Evidence (' .. v.how .. '):* ' .. proof))
  return box('verdict .' .. v.verdict:match '%a+', text, id)
end

---- within a line ----

local inline = {}

function inline.number(text)
  local file, key, column, form = text:match '^(%S+) (%S+) (%S+) (%d+%S*)$'
  if not file then stop 'expected <<number FILE ROW COLUMN DIGITS[*SCALE]>>' end
  local found = {}
  for _, row in ipairs(rows_of(read(data .. '/' .. file) or read(build .. '/' .. file) or stop("no file '%s'", file))) do
    if (table.concat(row, ',') .. ','):sub(1, #key + 1) == key .. ',' then found[#found + 1] = row end
  end
  if #found ~= 1 then stop("'%s' has %d rows '%s'", file, #found, key) end
  return decimal(tonumber(the("column of '" .. file .. "'", found[1], column)) or stop("'%s' is no number", found[1][column]), form)
end

function inline.value(text)
  local name, form, arguments = text:match '^(%S+) (%d+%S*) (.+)$'
  if not name then stop 'expected <<value NAME DIGITS[*SCALE] ARGUMENT ...>>' end
  local found = (output_of('"$CT_PROGRAM" ' .. arguments .. ' 2>&1') or ''):match('%f[%w_]' .. name .. ' += +(%S+)')
  return decimal(found or stop("coulomb-tether %s gives no '%s'", arguments, name), form)
end

function inline.quote(text)
  local id, before, quote, after = text:match '^(%S+) ([^|]*)|([^|]+)|?([^|]*)$'
  if not id then stop 'expected <<quote ID before|text|after>>' end
  if not the('verdict', verdicts, id).evidence:find(before .. quote .. after, 1, true) then
    stop("the evidence of '%s' does not read '%s'", id, before .. quote .. after)
  end
  return tonumber(quote) and (quote:gsub('^(.*)e(.*)$', scientific)) or typeset(quote)
end

function inline.count(what) return tostring(the('count', counts, what)) end

---- a line by itself ----

local block = {}

local FORMULAS = 'relation output let domain'
function block.equation(text)
  local id, named = text:match '^(%S+) ?(.*)$'
  local s = the('equation', sections, id)
  if #s.display == 0 then stop("'%s' has no formula in the sheet", id) end
  return equation(s, FORMULAS, named, qualified(id), targets(s))
end

function block.printed(text)
  local id, named = text:match '^(%S+) ?(.*)$'
  local s = the('equation', sections, id)
  if not s.reason then stop("'%s' is printed as the sheet has it", id) end
  return '\n\n**As printed.** ' .. prose(s.reason) .. equation(s, 'printed', named, 'as printed')
end

block['function'] = function(id)
  local s = the('equation', sections, id)
  return (#s.display == 0 and raw(targets(s)) or '') .. listing(gate[id]['function'])
end
block.helper = listing

function block.step(id)
  local s = the('derivation step', steps, id)
  if s.step.finding ~= 'holds' then stop("step '%s' does not hold: %s", id, s.step.evidence) end
  local leads = references(s.from) .. (#s.to > 0 and ' $\\;\\rightarrow\\;$ ' .. references(s.to) or '')
  local how = s.order and 'to order ' .. s.order or 'exactly'
  local text = ('$\\vdash$ `%s`: %s. %s. *Proved %s, for %s.*'):format(id, prose(s.title), leads, how, prose(s.domain))
  text = text .. (web and details('the algebra, line by line', algebra(s.lines)) or algebra(s.lines))
  if s.printed then text = text .. '\n\nAs printed the sides differ: ' .. prose(s.printed.evidence:match '; (.*)') .. '.' end
  if s.dropped then
    text = text .. '\n\nCertified: ' .. with_units(s.dropped:gsub('([%w_]+) %-(%d[%d.e+-]*) %.%.%. %2', '|%1| <= %2')) .. '.'
  end
  return box('step', text, 'step-' .. id)
end

function block.verdict(id) return verdict_of(the('verdict', verdicts, id)) end

function block.run(arguments) return code('$ coulomb-tether ' .. arguments .. '\n' .. run(arguments)) end

function block.findings(kind)
  the('verdict', counts, kind)
  local rows = verdicts:filter(function(v) return v.verdict == kind end):map(function(v)
    return ('| %s %s | %s | %s |'):format(typeset(v.claim_tex), name_of(v), typeset(v.where), typeset(v.why_tex or ''))
  end)
  local head = ('| claim | where | why |\n|%s|%s|%s|\n'):format(('-'):rep(37), ('-'):rep(19), ('-'):rep(44))
  return #rows == 0 and 'None.' or box('findings', head .. table.concat(rows, '\n'))
end

-- The heads of these tables stand in their chapters. In the sheet: "  NAME ...: {unit: U, ..., meaning: M}".
function block.symbols()
  local rows = {}
  for names, rest in read 'paper/equations.yaml':match '\nquantities:\n(.-)\n%a':gmatch '  ([^:\n]+): (%b{})' do
    local unit, meaning = rest:match 'unit: "?([^,"]*)', rest:match 'meaning: "?(.-)"?}$'
    names = names:gsub(' ', ', '):gsub('"?([%w_]+)"?', function(name)
      return formula(symbol[name] or '\\dot ' .. symbol[name:gsub('_dot', '', 1)])  -- a rate that no section computes
    end)
    rows[#rows + 1] = ('| %s | %s | %s |'):format(names, unit == '-' and '' or typeset(unit), prose(meaning))
  end
  return table.concat(rows, '\n')
end

function block.index()
  return table.concat(gate:map(function(g)
    local place = web and '[¶](equations.html#' .. g.id .. ')' or raw_inline('\\pageref{place:' .. g.id .. '}')
    return ('| %s %s | %s | `%s` | %s | %s | %s | %s |'):format(
      span_of(sections[g.id].numbers:map(equation_link)), qualified(g.id) or '', place, g['function'], g.tests,
      tonumber(g.error) and formula(decimal(g.error, '2')) or g.error, g.vectors, g.verdict)
  end), '\n')
end

-- Each equation with all that belongs to it.
function block.places()
  local out = {}
  for _, s in ipairs(sections) do
    local function add(text, ...) out[#out + 1] = text:format(...) end
    local g, q = gate[s.id], qualified(s.id)
    add('\n\n## [¶](#%s){.permalink} (%s) %s%s {#%s}\n\n', s.id, span_of(s.numbers), prose(s.title), q and ', ' .. q or '', s.id)
    add('%s%s%s%s', raw(targets(s), 'html'), equation(s, FORMULAS, '', q), prose(s.note or ''), s.reason and block.printed(s.id) or '')
    local last = {}  -- once where (2a), (2b) and (2c) have the same
    for _, number in ipairs(s.names) do
      local v = verdicts['equation-' .. number] or last
      if v.claim ~= last.claim or v.evidence ~= last.evidence then add('%s', verdict_of(v)) end
      last = v
    end
    local from, to, by = pandoc.List(), pandoc.List(), {}
    local function here(entry) return (section_of[entry] or entry:match '^[^.]*') == s.id end
    for _, step in ipairs(steps) do
      if pandoc.List(step.from):find_if(here) then to:extend(step.to) end
      if pandoc.List(step.to):find_if(here) then
        from:extend(step.from)
        by[#by + 1] = ('[`%s`](%s#step-%s)'):format(step.id, page_of_step[step.id], step.id)
      end
    end
    if #by > 0 then add('\n\n**Comes from** %s, by %s', references(from), table.concat(by, ', ')) end
    if #to > 0 then add('\n\n**Leads to** %s', references(to)) end
    if g.vectors ~= '-' then
      add('%s\n\n**Error and vectors.** %s %s tests, [%s golden vectors](data/%s.csv.gz). How to check yours:%s',
          details('C: <code>' .. g['function'] .. '</code>', listing(g['function'])),
          tonumber(g.error) and ('The largest backward error of the function is $E=%s$ on %s random inputs;')
                                :format(decimal(g.error, '2'), inputs) or 'Judged by correct digits;',
          g.tests, g.vectors, s.id, code('coulomb-tether conform --only ' .. s.id .. ' -- ./my-client'))
    end
  end
  return table.concat(out)
end

function block.verdicts()
  return table.concat(verdicts:map(function(v) return verdict_of(v, v.id) end))
end

---- figures ----

-- What a chapter's steps lead from and to. Steps are filled boxes, equations ellipses and where they are definitions octagons,
-- what steps lead to besides notes, what none leads to houses.
local function graph_of(chapter)
  local reached, lines = {}, {}
  for _, step in ipairs(steps) do
    for _, entry in ipairs(step.to) do reached[entry:match '^[^.]*'] = true end
  end
  local function add(text, ...) lines[#lines + 1] = text:format(...) end
  local function node(entry)  -- "6a", "eq06" and "eq06.x1" are the node 6
    local number = entry:match '^e?q?0*(%d+)'
    local name = number or entry:match '^[^.]*'
    local defined = number and gate[section_of[number]]['function'] == '(definition)'
    add('"%s" [style=solid, shape=%s, URL="%s"]', name, defined and 'doubleoctagon' or number and 'ellipse' or
        reached[name] and 'note' or 'house', number and 'equations.html#eq:' .. number or '')
    return name
  end
  for _, step in ipairs(steps) do
    if page_of_step[step.id] == chapter .. '.html' then
      add('"%s" [label="%s", URL="#step-%s"]', step.id, (step.id:gsub('_', ' ')), step.id)
      for _, entry in ipairs(step.from) do add('"%s" -> "%s" [arrowhead=none]', node(entry), step.id) end
      for _, entry in ipairs(step.to) do add('"%s" -> "%s"', step.id, node(entry)) end
    end
  end
  return 'strict digraph { bgcolor=transparent; ranksep=0.3; nodesep=0.06; margin=0; node [fontname=Helvetica, fontsize=10, '
         .. 'height=0.1, width=0.1, margin="0.03,0.02", shape=box, style=filled, fillcolor="#eeeeee"];' .. table.concat(lines, ';') .. '}'
end

local function figure(caption, target)
  local kind, name = target:match '^(%a+):(.*)$'
  local source = {plot = 'paper/figures/plot-%s.gp', graph = 'paper/%s.md'}
  if not read(the('picture', source, kind):format(name)) then stop("unknown picture '%s'", target) end
  if caption == '' then stop("'%s' has no caption", target) end
  local id, label = 'fig:' .. name, labels['fig:' .. name]  -- pages between the chapters have none
  if web then
    local named = label and 'Figure ' .. label.text or ''
    local drawn = kind == 'graph' and pandoc.pipe('dot', {'-Tsvg'}, graph_of(name)):match '<svg.*'
                  or ('<img src="plot-%s.svg" alt="%s">'):format(name, named)
    return raw('<figure id="' .. id .. '">' .. drawn .. '<figcaption>', 'html') .. (label and '**' .. named .. '.** ' or '')
           .. caption .. raw('</figcaption></figure>', 'html')
  end
  if kind == 'graph' then pandoc.pipe('dot', {'-Tpdf', '-o', build .. '/paper/graph-' .. name .. '.pdf'}, graph_of(name)) end
  return raw_inline(('\\begin{figure}[tbp]\\centering\\%s{%s}\\def\\thefigure{%s}\\caption{'):format(kind, name, label.text))
         .. caption .. raw_inline('}\\label{' .. id .. '}\\end{figure}')
end

---- the document ----

local function woven(line)
  local keys, row = line:match '^<<rows ([^>]*)>> *(.*)$'
  if keys then
    return (keys:gsub('(%S+) *', function(key)
      local parts = {key:match '^([^,]*),?(.*)$'}
      return woven((row:gsub('@(%d?)', function(i) return parts[tonumber(i)] or key end))) .. '\n'
    end):sub(1, -2))
  end
  local name, rest = line:match '^<<(%a*) *(.*)>>$'
  if name and not inline[name] then return the('directive', block, name)(rest) end
  line = line:gsub('()<<((%a*) *(.-))>>', function(at, text, name, rest)
    if (name == 'number' or name == 'value') and select(2, line:sub(1, at):gsub('%$', '')) % 2 == 0 then
      stop("'%s' is mathematics, expected dollars around it", text)
    end
    return the('directive within a line', inline, name)(rest)
  end)
  if line:find('<<', 1, true) then stop "'<<' without its '>>' on the same line" end
  line = line:gsub('%[([^%[%]]*)%]%(#([^%s()]+)%)', link)
  if not web then line = line:gsub('%[%]{#(ref:%w+)}', '\\phantomsection\\label{%1}') end
  local title, id = line:match '^# (.*) {#(%S+)}$'
  if web and id then return ('# %s %s {#%s}'):format(labels[id].text, title, id) end
  local caption, target = line:match '^!%[(.*)%]%(([^()]*)%)$'
  return target and figure(caption, target) or line
end

function Reader(sources)
  local out = {}
  for _, source in ipairs(sources) do
    local number = 0
    for line in (source.text .. '\n'):gmatch '([^\n]*)\n' do
      number = number + 1
      where = source.name .. ':' .. number
      local fine, text = pcall(woven, line)
      if not fine and text ~= stop then error(text) end
      out[#out + 1] = fine and text or ''
    end
    out[#out + 1] = ''
  end
  if stops > 0 then os.exit(1) end
  local doc = pandoc.read(table.concat(out, '\n'), 'markdown-implicit_figures-fancy_lists')
  doc.meta = {title = 'The Coulomb tether, checked by machine', pages = pages}
  for i, p in ipairs(pages) do
    if p.file == web then doc.meta.title, doc.meta.before, doc.meta.after = p.title, pages[i - 1], pages[i + 1] end
  end
  return doc:walk {
    -- In MathML upright letters are text, or each would be one of its own; and a product has its space anyway.
    Math = web and function(el) el.text = el.text:gsub('\\mathrm(%b{})', '{\\text%1}'):gsub('\\,', ' ') return el end,
    Div = not web and function(el)
      local function mark(name) return pandoc.RawBlock('latex', '\\' .. name .. '{' .. el.classes[1] .. '}') end
      return pandoc.List {mark 'begin'} .. el.content .. {mark 'end'}
    end,
  }
end
